//! Options about lines on the faces of voxels.

use crate::failure::Failure;
use crate::parse;
use voxtrace::Frame;
use voxtrace::glam::Vec3;
use voxtrace::import::{Content, vox};
use voxtrace::lines::{GridLines, Line, Lines};

/// Options about lines on the faces of voxels.
#[derive(clap::Args, Clone, Copy, Debug, Default)]
#[command(next_help_heading = "Lines")]
pub struct LineArgs {
    /// Draw lines along the edges of shapes, WIDTH voxels wide; `file`: those of the .vox file [default with no value: 0.2,#000000]
    #[arg(long, value_name = "WIDTH[,COLOR]|file", num_args = 0..=1, require_equals = true, default_missing_value = "0.2")]
    #[arg(value_parser = edges)]
    edges: Option<Edges>,
    /// Draw lines between voxels, WIDTH voxels wide and SPACING voxels apart; `file`: those of the .vox file [default with no value: 0.05,#000000,1]
    #[arg(long, value_name = "WIDTH[,COLOR[,SPACING]]|file", num_args = 0..=1, require_equals = true)]
    #[arg(default_missing_value = "0.05", value_parser = grid)]
    grid: Option<Grid>,
}

/// `--edges`.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Edges {
    OfFile,
    Given(Line),
}

/// `--grid`.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Grid {
    OfFile,
    Given(GridLines),
}

impl LineArgs {
    /// What they ask for, some of it from the scene's file.
    pub fn of(&self, content: &Content) -> Result<Lines, Failure> {
        let own = if let Content::Scene(scene) = content { vox::lines(scene) } else { Lines::default() };
        let lacks = |what: &str, option: &str| {
            Failure::usage(format!("the file shows no {what}")).hint(format!("say how they look: {option}"))
        };
        let edges = match self.edges {
            Some(Edges::OfFile) => Some(own.edges.ok_or_else(|| lacks("edges", "--edges=0.2,#000000"))?),
            Some(Edges::Given(line)) => Some(line),
            None => None,
        };
        let grid = match self.grid {
            Some(Grid::OfFile) => Some(own.grid.ok_or_else(|| lacks("grid", "--grid=0.05,#000000,1"))?),
            Some(Grid::Given(grid)) => Some(grid),
            None => None,
        };
        Ok(Lines { edges, grid })
    }
}

/// What is asked for, else what the film that is continued has.
pub fn or_of_film(asked: Lines, film: Option<&Frame>) -> Lines {
    let of_film = film.map(|film| film.lines).unwrap_or_default();
    Lines { edges: asked.edges.or(of_film.edges), grid: asked.grid.or(of_film.grid) }
}

/// `width`, `width,#rrggbb` or `width,r,g,b`.
fn edges(text: &str) -> Result<Edges, String> {
    if text == "file" {
        return Ok(Edges::OfFile);
    }
    let (line, rest) = line(text)?;
    if !rest.is_empty() {
        return Err("edges have a width and a colour, like 0.2,#ffffff".into());
    }
    Lines { edges: Some(line), grid: None }.check()?;
    Ok(Edges::Given(line))
}

/// The same, and either with `,spacing` behind the colour.
fn grid(text: &str) -> Result<Grid, String> {
    if text == "file" {
        return Ok(Grid::OfFile);
    }
    let (line, rest) = line(text)?;
    let spacing = match rest.strip_prefix(',') {
        Some(spacing) => spacing.parse().map_err(|_| format!("{spacing:?} is no number of voxels"))?,
        None => 1,
    };
    let grid = GridLines { line, spacing };
    Lines { edges: None, grid: Some(grid) }.check()?;
    Ok(Grid::Given(grid))
}

/// A line, and what is behind its colour, from its comma on.
fn line(text: &str) -> Result<(Line, &str), String> {
    let (width, rest) = text.split_once(',').map_or((text, None), |(width, rest)| (width, Some(rest)));
    let width = parse::finite(width)?;
    let Some(rest) = rest else { return Ok((Line { width, color: Vec3::ZERO }, "")) };
    let end = parse::end_of_color(rest);
    Ok((Line { width, color: parse::color(&rest[..end])? }, &rest[end..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_a_width_with_a_colour_and_a_spacing_where_they_say_them() {
        let line = |width, color: [f32; 3]| Line { width, color: Vec3::from(color) };
        let of_edges = |width, color| Ok(Edges::Given(line(width, color)));
        assert_eq!(edges("0.25"), of_edges(0.25, [0.0; 3]));
        assert_eq!(edges("1,#ff0000"), of_edges(1.0, [1.0, 0.0, 0.0]));
        assert_eq!(edges("0.5,0.25,0.5,1"), of_edges(0.5, [0.25, 0.5, 1.0]));
        let of_grid = |width, color, spacing| Ok(Grid::Given(GridLines { line: line(width, color), spacing }));
        assert_eq!(grid("0.25"), of_grid(0.25, [0.0; 3], 1));
        assert_eq!(grid("1.5,#ffffff,16"), of_grid(1.5, [1.0; 3], 16));
        assert_eq!(grid("0.25,0,1,0.5,4"), of_grid(0.25, [0.0, 1.0, 0.5], 4));
        assert_eq!((edges("file"), grid("file")), (Ok(Edges::OfFile), Ok(Grid::OfFile)));
        for wrong in ["", "0", "-1", "1.5", "nan", "0.2,", "0.2,red", "0.2,2,0,0", "0.2,0,0", "0.2,#000000,2", "0.2,é"]
        {
            assert!(edges(wrong).is_err(), "{wrong}");
        }
        for wrong in ["0", "2", "2.5,#000000,2", "0.2,#000000,0", "0.2,#000000,-1", "0.2,#000000,1.5", "0.2,0,0,0,9,9"]
        {
            assert!(grid(wrong).is_err(), "{wrong}");
        }
    }
}
