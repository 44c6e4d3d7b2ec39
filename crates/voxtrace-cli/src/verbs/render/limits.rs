//! Options about how far paths go by kind of bounce, and what counts of their light.

use crate::parse;
use voxtrace::{BounceLimits, Frame};

/// Options about paths, beside `--max-bounces`.
#[derive(clap::Args, Clone, Copy, Debug)]
#[command(next_help_heading = "Quality")]
pub struct LimitArgs {
    /// Most bounces off matte surfaces [default: all]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(0..=254))]
    diffuse_bounces: Option<u8>,
    /// Most reflections by metals and glass [default: all]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(0..=254))]
    glossy_bounces: Option<u8>,
    /// Most boundaries of glass that refract a path [default: all]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(0..=254))]
    transmitted_bounces: Option<u8>,
    /// Most bounces within clouds and other media [default: all]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(0..=254))]
    volume_bounces: Option<u8>,
    /// Let no bounce add more than this radiance of indirect light: less noise, but a picture that is too dark there
    #[arg(long, value_name = "RADIANCE", value_parser = above_zero)]
    clamp_indirect: Option<f32>,
    /// Let light pass clear glass straight, less what it reflects and absorbs: shadows behind panes without noise, but nothing that glass would focus
    #[arg(long)]
    clear_shadows: bool,
}

/// Parses a number above 0.
fn above_zero(text: &str) -> Result<f32, String> {
    let value = parse::positive(text)?;
    if value > 0.0 { Ok(value) } else { Err("a number above 0 is needed".into()) }
}

impl LimitArgs {
    /// What is asked for, else what the film that is continued has.
    pub fn bounces(&self, film: Option<&Frame>) -> BounceLimits {
        let of_film = film.map(|film| film.bounce_limits).unwrap_or_default();
        BounceLimits {
            diffuse: self.diffuse_bounces.unwrap_or(of_film.diffuse),
            glossy: self.glossy_bounces.unwrap_or(of_film.glossy),
            transmitted: self.transmitted_bounces.unwrap_or(of_film.transmitted),
            volume: self.volume_bounces.unwrap_or(of_film.volume),
        }
    }

    /// As [`Self::bounces`].
    pub fn clear_shadows(&self, film: Option<&Frame>) -> bool {
        self.clear_shadows || film.is_some_and(|film| film.clear_shadows)
    }

    /// As [`Self::bounces`]; infinite where nothing is clamped.
    pub fn clamp_indirect(&self, film: Option<&Frame>) -> f32 {
        self.clamp_indirect.or(film.map(|film| film.clamp_indirect)).unwrap_or(f32::INFINITY)
    }
}
