//! Options that cut a scene open.

use crate::failure::Failure;
use crate::parse;
use crate::report::Report;
use voxtrace::PackedScene;
use voxtrace::cuts::{CutError, Cuts};
use voxtrace::glam::Vec3;
#[cfg(feature = "view")]
use voxtrace_viewer::cutting::{Cutting, Slice as CutSlice};

/// Most `--clip-plane`s.
const MOST_PLANES: usize = 6;

/// Options that cut a scene open.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Cuts")]
pub struct CutArgs {
    /// Show only what lies within a box, in voxels of the scene as for --eye; what is cut is shown filled
    #[arg(long, value_name = "X0,Y0,Z0,X1,Y1,Z1", value_parser = clip_box, allow_hyphen_values = true)]
    clip_box: Option<[Vec3; 2]>,
    /// Show only the points p with n · p <= d: the normal points to what is cut away; up to six times
    #[arg(long, value_name = "NX,NY,NZ,D", value_parser = clip_plane, allow_hyphen_values = true)]
    clip_plane: Vec<(Vec3, f32)>,
    /// Show only a slice, from a position on an axis on [default thickness: 1 voxel], for example z=40 or y=-12.5,3
    #[arg(long, value_name = "AXIS=POSITION[,THICKNESS]", value_parser = slice)]
    slice: Option<Slice>,
    /// Keep the light of the whole scene: what is cut away still casts shadows, shines and reflects
    #[arg(long)]
    clip_shadows: bool,
}

/// Part of a scene between two planes.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Slice {
    axis: usize,
    from: f32,
    thickness: f32,
}

impl CutArgs {
    /// Cuts a scene as asked for; without planes it stays as it is.
    pub fn apply(&self, scene: &mut PackedScene) -> Result<(), Failure> {
        let cuts = self.cuts()?;
        if !cuts.is_none() {
            scene.cuts = cuts;
        } else if self.clip_shadows {
            if scene.cuts.is_none() {
                return Err(Failure::usage("--clip-shadows says how a cut is lit, and there is none")
                    .hint("cut the scene with --clip-box, --clip-plane or --slice"));
            }
            scene.cuts = scene.cuts.clone().shadows(true);
        }
        Ok(())
    }

    /// Takes them out: the window has settings of its own for them.
    #[cfg(feature = "view")]
    pub fn take_cutting(&mut self) -> Cutting {
        let slice =
            self.slice.take().map(|slice| CutSlice { axis: slice.axis, from: slice.from, thickness: slice.thickness });
        let (clip_box, planes) = (self.clip_box.take(), std::mem::take(&mut self.clip_plane));
        Cutting { clip_box, slice, planes, shadows: std::mem::take(&mut self.clip_shadows) }
    }

    /// Says so where nothing is left of a scene, and where it is.
    pub fn warn_of_nothing(scene: &PackedScene, report: &Report) {
        let Some(bounds) = scene.bounds().filter(|&bounds| scene.cuts.cut_away(bounds)) else { return };
        report.warn(&format!("nothing is left of the scene, which spans {}", span_text(bounds)));
    }

    /// Whether a plane is asked for.
    pub fn is_cut(&self) -> bool {
        self.clip_box.is_some() || !self.clip_plane.is_empty() || self.slice.is_some()
    }

    /// Refuses cuts that cannot be made.
    pub fn check(&self) -> Result<(), Failure> {
        self.apply(&mut PackedScene::empty())
    }

    fn cuts(&self) -> Result<Cuts, Failure> {
        if self.clip_plane.len() > MOST_PLANES {
            return Err(Failure::usage(format!("--clip-plane is given at most {MOST_PLANES} times")));
        }
        let planned = || -> Result<Cuts, CutError> {
            let mut cuts = Cuts::default().shadows(self.clip_shadows);
            if let Some([min, max]) = self.clip_box {
                cuts = cuts.clip_box(min, max)?;
            }
            if let Some(Slice { axis, from, thickness }) = self.slice {
                cuts = cuts.slice(axis, from, from + thickness)?;
            }
            self.clip_plane.iter().try_fold(cuts, |cuts, &(normal, offset)| cuts.plane(normal, offset))
        };
        planned().map_err(Failure::usage)
    }
}

/// From where to where a box goes along each axis.
pub fn span_text((min, max): (Vec3, Vec3)) -> String {
    let axes = ["x", "y", "z"].into_iter().zip(min.to_array().into_iter().zip(max.to_array()));
    let spans: Vec<String> = axes.map(|(axis, (from, to))| format!("{axis} {from} to {to}")).collect();
    spans.join(", ")
}

/// Numbers with commas between them.
fn numbers<const N: usize>(text: &str) -> Result<[f32; N], String> {
    let numbers: Vec<f32> = text.split(',').map(parse::finite).collect::<Result<_, _>>()?;
    numbers.try_into().map_err(|_| format!("{text:?} is not {N} numbers with commas between them"))
}

fn clip_box(text: &str) -> Result<[Vec3; 2], String> {
    let [x0, y0, z0, x1, y1, z1] = numbers(text)?;
    let (min, max) = (Vec3::new(x0, y0, z0), Vec3::new(x1, y1, z1));
    if min.cmplt(max).all() { Ok([min, max]) } else { Err("x0 < x1, y0 < y1 and z0 < z1 are needed".into()) }
}

fn clip_plane(text: &str) -> Result<(Vec3, f32), String> {
    let [x, y, z, offset] = numbers(text)?;
    let normal = Vec3::new(x, y, z);
    if normal == Vec3::ZERO { Err("a normal has a length".into()) } else { Ok((normal, offset)) }
}

fn slice(text: &str) -> Result<Slice, String> {
    let expected = || format!("{text:?} is not like z=40 or z=40,2.5");
    let (axis, place) = text.split_once('=').ok_or_else(expected)?;
    let axis = ["x", "y", "z"].iter().position(|&name| name == axis).ok_or_else(expected)?;
    let (from, thickness) = match place.split_once(',') {
        Some((from, thickness)) => (parse::finite(from)?, parse::finite(thickness)?),
        None => (parse::finite(place)?, 1.0),
    };
    if thickness <= 0.0 {
        Err("a slice has a thickness above 0".into())
    } else if from + thickness > from {
        Ok(Slice { axis, from, thickness })
    } else {
        Err(format!("a slice that is {thickness} thick cannot be told from nothing at {from}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(clap::Parser)]
    struct Words {
        #[command(flatten)]
        cuts: CutArgs,
    }

    fn parsed(text: &str) -> CutArgs {
        let words = ["cut"].into_iter().chain(text.split_whitespace());
        <Words as clap::Parser>::try_parse_from(words).unwrap_or_else(|error| panic!("{error}")).cuts
    }

    fn cut(text: &str) -> Result<Cuts, String> {
        let mut scene = PackedScene::empty();
        parsed(text).apply(&mut scene).map(|()| scene.cuts).map_err(|failure| failure.line())
    }

    #[test]
    fn options_become_planes() {
        assert_eq!(cut(""), Ok(Cuts::default()));
        let boxed = Cuts::default().clip_box(Vec3::new(-1.0, 2.0, 3.0), Vec3::new(4.0, 5.0, 6.5)).unwrap();
        assert_eq!(cut("--clip-box -1,2,3,4,5,6.5"), Ok(boxed.clone()));
        let all = boxed.slice(2, -4.0, -3.0).unwrap().plane(Vec3::new(0.0, -1.0, 1.0), 9.0).unwrap().shadows(true);
        assert_eq!(
            cut("--slice z=-4 --clip-plane 0,-1,1,9 --clip-box -1,2,3,4,5,6.5 --clip-shadows").as_ref(),
            Ok(&all)
        );
        assert_ne!(cut("--slice z=-4,2 --clip-plane 0,-1,1,9 --clip-box -1,2,3,4,5,6.5 --clip-shadows"), Ok(all));
    }

    #[test]
    fn cuts_that_leave_nothing_are_told_from_those_that_leave_a_corner() {
        let bounds = (Vec3::new(0.0, 0.0, 4.0), Vec3::new(40.0, 50.0, 45.0));
        let cuts = |text: &str| cut(text).unwrap().cut_away(bounds);
        assert!(cuts("--slice z=2") && cuts("--slice z=45.5") && cuts("--clip-plane 1,1,1,3.9"));
        assert!(!cuts("--slice z=4") && !cuts("--slice z=44.5") && !cuts("--clip-plane 1,1,1,4.1"));
        assert_eq!(span_text(bounds), "x 0 to 40, y 0 to 50, z 4 to 45");
    }

    #[test]
    fn what_cuts_nothing_is_refused() {
        for text in ["z", "z=", "w=3", "z=3,0", "z=3,-1", "x=1,2,3"] {
            assert!(slice(text).is_err(), "{text}");
        }
        assert!(slice("z=3,0").unwrap_err().contains("thickness above 0"));
        // So far away a number has no room for the thickness beside it.
        assert!(slice("z=1e9").unwrap_err().contains("1 thick cannot be told from nothing at 1000000000"));
        assert!(clip_box("0,0,0,1,1").is_err() && clip_box("0,0,0,1,1,0").is_err());
        assert!(clip_plane("0,0,0,1").is_err() && clip_plane("0,0,1,inf").is_err());
        assert!(cut("--clip-shadows").unwrap_err().contains("there is none"));
        let six = "--clip-plane 0,0,1,9 ".repeat(6);
        assert!(cut(&six).is_ok());
        assert!(cut(&format!("{six} --clip-plane 1,0,0,9")).unwrap_err().contains("at most 6 times"));
        assert!(cut(&format!("{six} --clip-box 0,0,0,1,1,1 --slice x=1")).unwrap_err().contains("at most 12 planes"));
    }
}
