//! Options about the lens of a camera.

use crate::failure::Failure;
use crate::parse;
use voxtrace::camera::Lens;
use voxtrace::glam::{Vec2, Vec3};
use voxtrace::{Camera, PackedScene};

/// How a picture shows what is around the camera.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// Straight lines stay straight, distant things are small
    Pinhole,
    /// Parallel rays: distant things are as large as near ones
    Orthographic,
    /// Parallel rays, seen from a corner: all three axes are equally long
    Isometric,
    /// All directions: 360 degrees by 180, for pictures twice as wide as high
    Panorama,
    /// A wide angle, also beyond 180 degrees
    Fisheye,
}

/// Direction from the target to the eye of an isometric view: the quarter from which the automatic view looks, too.
pub const ISOMETRIC: Vec3 = Vec3::new(1.0, -1.0, 1.0);

/// Options about the lens.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Lens")]
pub struct LensArgs {
    /// How the picture shows what is around the camera [default: that of the camera, else pinhole]
    #[arg(long, value_enum)]
    pub projection: Option<Projection>,
    /// Height of what an orthographic or isometric picture shows, in voxels [default: what --fov shows at the target; of the camera `auto`, what shows everything]
    #[arg(long, value_name = "VOXELS", value_parser = parse::positive)]
    pub view_height: Option<f32>,
    /// Angle that the height of a fisheye's picture shows, in degrees, at most 360 [default: 180]
    #[arg(long, value_name = "DEGREES", value_parser = parse::positive)]
    pub fisheye_angle: Option<f32>,
    /// Make a panorama for two eyes this far apart, in voxels: the left eye's picture above the right one's
    #[arg(long, value_name = "VOXELS", value_parser = parse::positive)]
    pub eye_distance: Option<f32>,
    /// Radius of the aperture, in voxels: what is not in focus is blurred
    #[arg(long, value_name = "VOXELS", value_parser = parse::positive)]
    pub aperture: Option<f32>,
    /// Distance in focus, in voxels along the view [default: that of the target]; with --aperture
    #[arg(long, value_name = "VOXELS", value_parser = parse::positive, conflicts_with = "focus_on")]
    pub focus: Option<f32>,
    /// Focus on what this pixel of the picture shows, counted from the upper left; with --aperture
    #[arg(long, value_name = "X,Y", value_parser = parse::pixel)]
    pub focus_on: Option<(u32, u32)>,
    /// Blades of the diaphragm, 3 to 64 [default: none, a round opening]
    #[arg(long, value_name = "N")]
    pub blades: Option<u32>,
    /// Turn the diaphragm counterclockwise, in degrees [default: 0]
    #[arg(long, value_name = "DEGREES", value_parser = parse::finite, allow_hyphen_values = true)]
    pub blade_rotation: Option<f32>,
}

impl LensArgs {
    /// Whether any option says something about the lens.
    pub fn says_lens(&self) -> bool {
        let lengths =
            [self.view_height, self.fisheye_angle, self.eye_distance, self.aperture, self.focus, self.blade_rotation];
        self.projection.is_some()
            || self.focus_on.is_some()
            || self.blades.is_some()
            || lengths.iter().any(Option::is_some)
    }

    /// Gives `camera` the lens that is asked for, for pictures of `width` × `height` pixels of `scene`.
    pub fn apply(&self, camera: &mut Camera, scene: &PackedScene, (width, height): (u32, u32)) -> Result<(), Failure> {
        if self.projection == Some(Projection::Isometric) {
            camera.eye = camera.target + ISOMETRIC.normalize() * camera.eye.distance(camera.target);
            camera.up = Vec3::Z;
        }
        let lens = self.projection.map_or_else(|| camera.lens.name(), name_of);
        // A pinhole with an aperture is a thin lens.
        let name = if lens == "pinhole" && self.aperture.is_some() { "thin-lens" } else { lens };
        self.check_use(name)?;
        let old = camera.lens.settings();
        let kept = |key: &str| old.iter().find(|(name, _)| *name == key).map(|&(_, value)| value);
        let focus = self.focus_distance(camera, scene, (width, height))?;
        let setting = |key: &str| match key {
            "aperture" => self.aperture.or(kept(key)),
            "focus" => focus.or(kept(key)).or_else(|| Some(camera.focus_on(camera.target))),
            "blades" => self.blades.map(|blades| blades as f32).or(kept(key)),
            "blade_rotation" => self.blade_rotation.or(kept(key)),
            "view_height" => self.view_height.or(kept(key)).or_else(|| Some(camera.height_at_target())),
            "eye_distance" => self.eye_distance.or(kept(key)),
            "fisheye_angle" => self.fisheye_angle.or(kept(key)),
            _ => None,
        };
        camera.lens = Lens::from_settings(name, setting).map_err(Failure::usage)?;
        Ok(())
    }

    /// Refuses options that the lens would ignore.
    fn check_use(&self, lens: &str) -> Result<(), Failure> {
        let of_thin = ["thin-lens"].as_slice();
        let uses = [
            ("--aperture", self.aperture.is_some(), of_thin),
            ("--focus", self.focus.is_some(), of_thin),
            ("--focus-on", self.focus_on.is_some(), of_thin),
            ("--blades", self.blades.is_some(), of_thin),
            ("--blade-rotation", self.blade_rotation.is_some(), of_thin),
            ("--view-height", self.view_height.is_some(), &["orthographic"]),
            ("--eye-distance", self.eye_distance.is_some(), &["panorama"]),
            ("--fisheye-angle", self.fisheye_angle.is_some(), &["fisheye"]),
        ];
        let ignored = uses.into_iter().find(|(_, is_given, lenses)| *is_given && !lenses.contains(&lens));
        let Some((option, _, lenses)) = ignored else { return Ok(()) };
        let hint = match lenses[0] {
            "thin-lens" if lens == "pinhole" => "add --aperture".to_owned(),
            "thin-lens" => "--projection pinhole has an aperture".to_owned(),
            other => format!("add --projection {other}"),
        };
        Err(Failure::usage(format!("{option} means nothing for the lens {lens}")).hint(hint))
    }

    fn focus_distance(
        &self,
        camera: &Camera,
        scene: &PackedScene,
        (width, height): (u32, u32),
    ) -> Result<Option<f32>, Failure> {
        let Some((x, y)) = self.focus_on else { return Ok(self.focus) };
        if x >= width || y >= height {
            return Err(Failure::usage(format!(
                "the pixel {x},{y} of --focus-on is not in a picture of {width}x{height}"
            )));
        }
        let pinhole = camera.clone().with_lens(Lens::Pinhole);
        let ray = pinhole.frame(width, height).central_ray(Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
        let hit = scene.cast(&ray).ok_or_else(|| {
            Failure::usage(format!("the pixel {x},{y} of --focus-on shows only sky")).hint("--focus takes a distance")
        })?;
        Ok(Some(camera.focus_on(ray.origin + ray.direction * hit.t)))
    }
}

fn name_of(projection: Projection) -> &'static str {
    match projection {
        Projection::Pinhole => "pinhole",
        Projection::Orthographic | Projection::Isometric => "orthographic",
        Projection::Panorama => "panorama",
        Projection::Fisheye => "fisheye",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::glam::IVec3;
    use voxtrace::grid::VoxelBox;
    use voxtrace::{Material, Scene, VoxelGrid};

    fn scene() -> PackedScene {
        let mut grid = VoxelGrid::new();
        grid.fill_box(VoxelBox { min: IVec3::new(-20, 30, -20), max: IVec3::new(20, 31, 20) }, 0);
        PackedScene::pack(&Scene::from_grid("wall", grid, vec![Material::default()])).unwrap()
    }

    fn applied(args: &LensArgs) -> Result<Camera, String> {
        let mut camera = Camera::look_at(Vec3::ZERO, Vec3::Y * 10.0);
        args.apply(&mut camera, &scene(), (80, 60)).map(|()| camera).map_err(|failure| format!("{failure:?}"))
    }

    #[test]
    fn an_aperture_makes_a_thin_lens_that_is_sharp_at_the_target_or_where_a_pixel_looks() {
        let args = LensArgs { aperture: Some(0.5), ..LensArgs::default() };
        assert_eq!(applied(&args).unwrap().lens.settings()[..2], [("aperture", 0.5), ("focus", 10.0)]);
        // The wall stands 30 away, also for a pixel off the axis.
        let args = LensArgs { focus_on: Some((70, 10)), ..args };
        let (_, focus) = applied(&args).unwrap().lens.settings()[1];
        assert!((focus - 30.0).abs() < 1e-3, "{focus}");
        assert!(applied(&LensArgs { focus_on: Some((80, 0)), ..args.clone() }).unwrap_err().contains("80x60"));
        assert!(applied(&LensArgs { blades: Some(2), ..args }).unwrap_err().contains("blades"));
    }

    #[test]
    fn an_orthographic_picture_shows_at_the_target_what_the_pinhole_shows() {
        let args = LensArgs { projection: Some(Projection::Orthographic), ..LensArgs::default() };
        let camera = applied(&args).unwrap();
        let expected = 2.0 * 10.0 * (22.5_f32).to_radians().tan();
        let Lens::Orthographic { view_height } = camera.lens else { panic!("{camera:?}") };
        assert!((view_height - expected).abs() < 1e-4);
        let isometric = applied(&LensArgs { projection: Some(Projection::Isometric), ..args }).unwrap();
        let view = (isometric.target - isometric.eye).normalize();
        assert!(view.abs().abs_diff_eq(Vec3::splat(1.0 / 3.0_f32.sqrt()), 1e-6), "{view}");
    }

    #[test]
    fn options_that_the_lens_would_ignore_are_refused() {
        let refused = |args: LensArgs| applied(&args).unwrap_err();
        assert!(refused(LensArgs { focus: Some(3.0), ..LensArgs::default() }).contains("--aperture"));
        let fisheye = Some(Projection::Fisheye);
        assert!(
            refused(LensArgs { projection: fisheye, aperture: Some(1.0), ..LensArgs::default() }).contains("fisheye")
        );
        assert!(refused(LensArgs { view_height: Some(3.0), ..LensArgs::default() }).contains("orthographic"));
        assert!(
            refused(LensArgs { projection: fisheye, fisheye_angle: Some(400.0), ..LensArgs::default() })
                .contains("360")
        );
    }
}
