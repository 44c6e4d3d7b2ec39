//! How the window cuts a scene open: a box, a slice, planes, and whether what is cut away still casts shadows. All of it is also an
//! option of `voxtrace render`, in the order in which `render` makes the cuts.

use crate::scale::Scale;
use crate::session::Session;
use voxtrace::PackedScene;
use voxtrace::cuts::{CutError, Cuts, Plane};
use voxtrace::glam::{DAffine3, Vec3};

/// The least distance between two sides, voxels.
pub const LEAST: f32 = 0.1;

/// Most planes, as `render` takes them.
pub const MOST_PLANES: usize = 6;

/// What is kept of a scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cutting {
    /// `--clip-box`: the lowest and the highest corner, voxels of the scene.
    pub clip_box: Option<[Vec3; 2]>,
    /// `--slice`.
    pub slice: Option<Slice>,
    /// `--clip-plane`, at most [`MOST_PLANES`] times: normal and offset. Only the points p with n · p ≤ d are kept.
    pub planes: Vec<(Vec3, f32)>,
    /// `--clip-shadows`: whether the light is that of the whole scene.
    pub shadows: bool,
}

/// The part of a scene between two planes across an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slice {
    /// 0 is x, 1 is y, 2 is z.
    pub axis: usize,
    /// Where it begins, voxels.
    pub from: f32,
    /// How thick it is, voxels.
    pub thickness: f32,
}

impl Cutting {
    /// Whether something is cut away.
    pub fn is_cut(&self) -> bool {
        self.clip_box.is_some() || self.slice.is_some() || !self.planes.is_empty()
    }

    /// The cuts of a scene that has its `own` already, in the order in which `render` makes them.
    ///
    /// # Errors
    /// [`CutError`] where box or slice is empty, a plane has no normal, or where there are too many planes.
    pub fn cuts(&self, own: &Cuts) -> Result<Cuts, CutError> {
        let mut cuts = Cuts::default();
        if let Some([min, max]) = self.clip_box {
            cuts = cuts.clip_box(min, max)?;
        }
        if let Some(Slice { axis, from, thickness }) = self.slice {
            cuts = cuts.slice(axis, from, from + thickness)?;
        }
        cuts = self.planes.iter().try_fold(cuts, |cuts, &(normal, offset)| cuts.plane(normal, offset))?;
        let parts = |plane: &Plane| (plane.normal(), plane.offset());
        let all: Vec<(Vec3, f32)> = cuts.planes().iter().chain(own.planes()).map(parts).collect();
        let is_cut = !all.is_empty();
        Cuts::from_parts(&all, is_cut && (self.shadows || own.casts_shadows()))
    }

    /// Brings it into a world with voxels of another size, or of another place.
    pub(crate) fn transform(&mut self, new_from_old: &DAffine3) {
        let matrix = new_from_old.matrix3;
        let moved = |point: Vec3| new_from_old.transform_point3(point.as_dvec3()).as_vec3();
        if let Some([min, max]) = &mut self.clip_box {
            let corners = [moved(*min), moved(*max)];
            (*min, *max) = (corners[0].min(corners[1]), corners[0].max(corners[1]));
        }
        if let Some(Slice { axis, from, thickness }) = &mut self.slice {
            let mut place = Vec3::ZERO;
            place[*axis] = *from;
            *from = moved(place)[*axis];
            *thickness *= matrix.col(*axis)[*axis].abs() as f32;
        }
        for (normal, offset) in &mut self.planes {
            // By the inverse transpose, as normals are; it stays as long as it was.
            let own = normal.as_dvec3();
            let turned = matrix.inverse().transpose() * own;
            let factor = own.length() / turned.length();
            *offset = ((f64::from(*offset) + turned.dot(new_from_old.translation)) * factor) as f32;
            *normal = (turned * factor).as_vec3();
        }
    }
}

impl Session {
    /// The box of the whole scene, in whole voxels: what a box begins with.
    pub fn whole_box(&self) -> Option<[Vec3; 2]> {
        let (min, max) = self.open.as_ref()?.original.bounds()?;
        Some([min.floor(), max.ceil()])
    }

    /// The scene is about to be shown with other voxels: what is kept of it, what is around it and the camera's way stay in their place.
    pub(crate) fn stay_in_place(&mut self, scene: &PackedScene) {
        let Some(open) = &self.open else { return };
        let (old, new) = (Scale::of(&open.original), Scale::of(scene));
        if old == new {
            return;
        }
        let new_from_old = new.world_from_other(&old);
        self.render_settings.cutting.transform(&new_from_old);
        self.render_settings.surroundings.transform(&new_from_old);
        self.time_in(&new_from_old);
    }

    /// Cuts the scene open, or closes it. A file that leaves out what nobody sees inside is read again.
    pub fn set_cutting(&mut self, cutting: Cutting) {
        let Some(open) = &self.open else { return };
        if let Err(error) = cutting.cuts(&open.original.cuts) {
            self.say(error.to_string(), true);
            return;
        }
        let has_edits = self.editing.as_ref().is_some_and(crate::editing::Editing::has_edits_beside_file);
        let is_read_otherwise =
            !has_edits && open.depends_on_cuts && cutting.is_cut() != self.render_settings.cutting.is_cut();
        let settings = crate::render_settings::RenderSettings { cutting, ..self.render_settings.clone() };
        self.set_render_settings(settings);
        if is_read_otherwise {
            self.ask(crate::session::Command::LoadAgain);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::glam::DVec3;

    #[test]
    fn in_voxels_of_another_size_and_place_the_same_points_are_kept() {
        let new_from_old = DAffine3::from_translation(DVec3::splat(40.0)) * DAffine3::from_scale(DVec3::splat(2.0));
        let slice = Slice { axis: 2, from: 3.0, thickness: 1.5 };
        let planes = vec![(Vec3::new(0.0, 3.0, 4.0), 7.0)];
        let clip_box = Some([Vec3::new(-1.5, 0.0, 2.0), Vec3::splat(9.0)]);
        let mut cutting = Cutting { clip_box, slice: Some(slice), planes, shadows: true };
        cutting.transform(&new_from_old);
        assert_eq!(cutting.clip_box, Some([Vec3::new(37.0, 40.0, 44.0), Vec3::splat(58.0)]));
        assert_eq!(cutting.slice, Some(Slice { axis: 2, from: 46.0, thickness: 3.0 }));
        let (normal, offset) = cutting.planes[0];
        assert!(normal.distance(Vec3::new(0.0, 3.0, 4.0)) < 1e-5, "{normal}");
        // The point (0, 1, 1) was on the plane.
        assert!((normal.dot(Vec3::new(40.0, 42.0, 42.0)) - offset).abs() < 1e-3, "{offset}");
    }

    #[test]
    fn cuts_come_in_the_order_of_render_and_those_of_the_scene_stay() {
        let own = Cuts::default().plane(Vec3::new(0.0, 3.0, 4.0), 7.0).unwrap();
        let (min, max) = (Vec3::new(-1.5, 0.0, 2.0), Vec3::splat(9.0));
        let slice = Slice { axis: 1, from: 3.3, thickness: 0.7 };
        let both = Cutting { clip_box: Some([min, max]), slice: Some(slice), ..Cutting::default() };
        let expected = |from: f32, to: f32| {
            let cuts = Cuts::default().clip_box(min, max).unwrap().slice(1, from, to).unwrap();
            cuts.plane(Vec3::new(0.0, 3.0, 4.0), 7.0).unwrap()
        };
        assert_eq!(both.cuts(&own), Ok(expected(3.3, 3.3 + 0.7)));
        assert_ne!(both.cuts(&own), Ok(expected(3.3, 4.1)), "the comparison sees a tenth of a voxel");
        assert_eq!(Cutting { shadows: true, ..both.clone() }.cuts(&own), Ok(expected(3.3, 3.3 + 0.7).shadows(true)));
        assert_eq!(Cutting { shadows: true, ..Cutting::default() }.cuts(&Cuts::default()), Ok(Cuts::default()));
        assert_eq!(Cutting::default().cuts(&own.clone().shadows(true)), Ok(own.shadows(true)));
        let plane = (Vec3::new(0.0, 3.0, 4.0), 7.0);
        let planes = vec![plane, (Vec3::NEG_X, 2.0)];
        let with_planes = Cutting { planes: planes.clone(), ..both.clone() }.cuts(&Cuts::default());
        assert_eq!(with_planes, expected(3.3, 3.3 + 0.7).plane(Vec3::NEG_X, 2.0));
        let turned = Cutting { planes: planes.into_iter().rev().collect(), ..both.clone() };
        assert_ne!(turned.cuts(&Cuts::default()), with_planes, "the comparison sees their order");
        let empty = Cutting { slice: Some(Slice { thickness: 0.0, ..slice }), ..Cutting::default() };
        assert_eq!(empty.cuts(&Cuts::default()), Err(CutError::EmptyBox));
    }
}
