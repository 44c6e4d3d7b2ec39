//! What devices are told of a frame: the record that shaders read (`shaders/frame.slang`), and what they are specialized for
//! (`shaders/variant.slang`). Shaders have both from here (`docs/decisions/0041-one-table-of-records.md`).

use crate::cuts::Cuts;
use crate::light::{SunDisc, irradiance_of};
use crate::lines::{GridLines, Line, Lines};
use crate::shadow_catcher::ShadowCatcher;
use crate::{BounceLimits, Frame, LightGroup, PackedScene};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use voxtrace_scene::camera::{Axes, CameraFrame, Fisheye, Orthographic, Panorama, Perspective, ThinLens};
use voxtrace_scene::sky::{Background, Gradient};

/// The input of one render call.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct FrameParams {
    /// Ray origin, world space.
    pub eye: Vec3,
    /// Width of the whole picture, pixels.
    pub width: u32,
    /// Direction of the upper left corner of the picture.
    pub corner: Vec3,
    /// Height of the whole picture, pixels.
    pub height: u32,
    /// Step of one pixel to the right.
    pub pixel_x: Vec3,
    /// Which lens, one of `LENS_`: that of the pipeline, which is specialized for it.
    pub lens: u32,
    /// Step of one pixel down.
    pub pixel_y: Vec3,
    /// Which sky, one of `SKY_`: that of the pipeline, which is specialized for it.
    pub sky: u32,
    /// The part to render: x0, y0, x1, y1.
    pub region: [u32; 4],
    /// Most surfaces that scatter one path.
    pub max_bounces: u32,
    /// 1 where camera rays that meet nothing leave their sample black.
    pub is_transparent: u32,
    /// Number of the first sample of each pixel.
    pub first_sample: u32,
    /// Seed of the random numbers.
    pub seed: u32,
    /// Radiance straight down.
    pub sky_nadir: Vec3,
    /// Factor on the whole sky.
    pub sky_brightness: f32,
    /// Radiance straight up.
    pub sky_zenith: Vec3,
    /// Factor on every material's emission.
    pub light_intensity: f32,
    /// Unit vector towards the sun's centre.
    pub sun_direction: Vec3,
    /// 1 − cos of the sun's angular radius.
    pub sun_one_minus_cos_theta_max: f32,
    /// Unit vector at right angles to the sun's direction.
    pub sun_tangent: Vec3,
    /// Sine of the sun's angular radius.
    pub sun_sin_radius: f32,
    /// Unit vector at right angles to both.
    pub sun_bitangent: Vec3,
    /// Luminance of the sun's irradiance, 0 where there is no sun.
    pub sun_irradiance: f32,
    /// Radiance of the sun's disc.
    pub sun_radiance: Vec3,
    /// Density of a uniform direction of the sun's disc.
    pub sun_pdf: f32,
    /// Thin lens: radius of the aperture along one direction. Parallel rays: their direction. Panorama: one over the width of the picture and over the
    /// height of one eye's, and half the distance of the eyes. Fisheye: the middle of the picture and the turns of a pixel.
    pub lens_x: Vec3,
    /// Number of nodes of the tree over the instances that emit.
    pub light_node_count: u32,
    /// Thin lens: radius of the aperture along the other direction.
    pub lens_y: Vec3,
    /// Thin lens: blades of the diaphragm, 0 for a round one.
    pub blades: u32,
    /// Environment map: sine and cosine of the angle by which it is turned clockwise.
    pub sky_turned: [f32; 2],
    /// Environment map: texels along an edge.
    pub sky_edge: u32,
    /// Luminance of the irradiance of a sky whose directions are chosen, 0 where none is.
    pub sky_irradiance: f32,
    /// Factor on the emission that is gathered: `light_intensity`, or 0 where emitters are left out, which changes nothing about their choice.
    pub emitter_intensity: f32,
    /// Most bounces of each kind, eight bits each: diffuse, glossy, transmitted, volume; 255 is no limit.
    pub bounce_limits: u32,
    /// Most radiance that one bounce adds of indirect light, infinite where it is not clamped.
    pub clamp_indirect: f32,
    /// Number of instances.
    pub instance_count: u32,
    /// Planes of the cuts: unit normals, which point to what is cut away, and offsets at which they cut.
    pub planes: [[f32; 4]; 12],
    /// How many of them there are.
    pub plane_count: u32,
    /// 1 where what is cut away takes part in the light.
    pub cuts_cast_shadows: u32,
    /// 1 where light passes clear glass straight.
    pub clear_shadows: u32,
    /// 1 where a camera does not see the disc of the sun.
    pub hides_sun_disc: u32,
    /// Material of the ground without end, `u32::MAX` where there is none.
    pub ground_material: u32,
    /// Where the ground shows shadows alone: [`ShadowCatcher::sun_share`].
    pub catcher_sun_share: f32,
    /// [`ShadowCatcher::cube_share`].
    pub catcher_cube_share: f32,
    /// Lines of a grid: how many voxels apart.
    pub grid_spacing: u32,
    /// Lines along the edges of shapes: reflectance.
    pub edge_color: Vec3,
    /// Their width, voxels, 0 where there are none.
    pub edge_width: f32,
    /// Lines of a grid: reflectance.
    pub grid_color: Vec3,
    /// Their width, voxels, 0 where there are none.
    pub grid_width: f32,
}

/// The sky is a gradient.
pub const SKY_GRADIENT: u32 = 0;
/// The sky is an environment map.
pub const SKY_ENVIRONMENT: u32 = 1;

/// The lens sends all rays through one point.
pub const LENS_PINHOLE: u32 = 0;
/// A thin lens.
pub const LENS_THIN: u32 = 1;
/// Parallel rays; `corner` is where the ray of the upper left corner starts.
pub const LENS_ORTHOGRAPHIC: u32 = 2;
/// Longitude and latitude; `corner`, `pixel_x` and `pixel_y` are the directions forward, right and up.
pub const LENS_PANORAMA: u32 = 3;
/// An equidistant fisheye; directions as for `LENS_PANORAMA`.
pub const LENS_FISHEYE: u32 = 4;

impl FrameParams {
    /// What casting needs: the scene without a view.
    pub fn of_scene(scene: &PackedScene) -> Self {
        let background = match scene.sky.background() {
            Background::Gradient(Gradient { nadir, zenith }) => {
                Self { sky: SKY_GRADIENT, sky_nadir: *nadir, sky_zenith: *zenith, ..Self::default() }
            }
            Background::Environment(environment) => Self {
                sky: SKY_ENVIRONMENT,
                sky_turned: environment.turned().to_array(),
                sky_edge: environment.map().edge(),
                sky_irradiance: irradiance_of(&scene.sky),
                ..Self::default()
            },
        };
        let params = Self {
            instance_count: scene.instances().len() as u32,
            light_node_count: scene.placement().light_nodes().len() as u32,
            sky_brightness: scene.sky.brightness(),
            light_intensity: scene.light_intensity,
            emitter_intensity: scene.light_intensity,
            ..background.with_cuts(&scene.cuts)
        };
        let Some(sun) = SunDisc::new(&scene.sky) else { return params };
        Self {
            sun_direction: sun.direction,
            sun_one_minus_cos_theta_max: sun.one_minus_cos_theta_max,
            sun_tangent: sun.tangent,
            sun_sin_radius: sun.sin_radius,
            sun_bitangent: sun.bitangent,
            sun_irradiance: sun.irradiance,
            sun_radiance: sun.radiance,
            sun_pdf: sun.pdf,
            hides_sun_disc: (!sun.is_visible).into(),
            ..params
        }
    }

    fn with_cuts(mut self, cuts: &Cuts) -> Self {
        for (row, plane) in self.planes.iter_mut().zip(cuts.planes()) {
            *row = plane.normal().extend(plane.edge()).to_array();
        }
        Self { plane_count: cuts.planes().len() as u32, cuts_cast_shadows: cuts.casts_shadows().into(), ..self }
    }

    /// What a frame of the scene needs.
    pub fn of_frame(scene: &PackedScene, frame: &Frame) -> Self {
        let region = frame.region;
        Self {
            width: frame.width,
            height: frame.height,
            first_sample: frame.first_sample,
            seed: frame.seed,
            region: [region.x0, region.y0, region.x1, region.y1],
            // Where everything is matte all bounces are diffuse.
            max_bounces: match frame.bounce_limits.diffuse {
                limit if limit < BounceLimits::UNLIMITED && scene.is_matte() => frame.max_bounces.min(limit.into()),
                _ => frame.max_bounces,
            },
            bounce_limits: frame.bounce_limits.to_bits(),
            clamp_indirect: frame.clamp_indirect,
            clear_shadows: frame.clear_shadows.into(),
            is_transparent: frame.transparent.into(),
            ground_material: scene.ground_material().unwrap_or(u32::MAX),
            ..Self::of_scene(scene).of_group(frame.light_group)
        }
        .with_catcher(ShadowCatcher::new(scene, frame))
        .with_lines(&frame.lines)
        .with_camera(&frame.camera.frame(frame.width, frame.height))
    }

    fn with_catcher(self, catcher: Option<ShadowCatcher>) -> Self {
        let Some(ShadowCatcher { sun_share, cube_share, .. }) = catcher else { return self };
        Self { catcher_sun_share: sun_share, catcher_cube_share: cube_share, ..self }
    }

    /// The same lights, chosen in the same way, of which those of a group alone shine.
    fn of_group(self, group: LightGroup) -> Self {
        let shining = |part: LightGroup| if group.has(part) { 1.0 } else { 0.0 };
        Self {
            sun_radiance: self.sun_radiance * shining(LightGroup::Sun),
            sky_brightness: self.sky_brightness * shining(LightGroup::Sky),
            emitter_intensity: self.emitter_intensity * shining(LightGroup::Emitters),
            ..self
        }
    }

    /// The same input with another camera.
    pub fn with_camera(self, camera: &CameraFrame) -> Self {
        let with =
            |lens, [eye, corner, pixel_x, pixel_y]: [Vec3; 4]| Self { lens, eye, corner, pixel_x, pixel_y, ..self };
        let of_axes = |lens, eye, Axes { forward, right, up }: Axes| with(lens, [eye, forward, right, up]);
        match *camera {
            CameraFrame::Perspective(Perspective { eye, corner, pixel_x, pixel_y }) => {
                with(LENS_PINHOLE, [eye, corner, pixel_x, pixel_y])
            }
            CameraFrame::ThinLens(ThinLens { perspective, lens_x, lens_y, blades }) => {
                let Perspective { eye, corner, pixel_x, pixel_y } = perspective;
                Self { lens_x, lens_y, blades, ..with(LENS_THIN, [eye, corner, pixel_x, pixel_y]) }
            }
            CameraFrame::Orthographic(Orthographic { corner, pixel_x, pixel_y, forward }) => {
                Self { lens_x: forward, ..with(LENS_ORTHOGRAPHIC, [Vec3::ZERO, corner, pixel_x, pixel_y]) }
            }
            CameraFrame::Panorama(Panorama { eye, axes, inverse_size, half_eye_distance }) => {
                Self { lens_x: inverse_size.extend(half_eye_distance), ..of_axes(LENS_PANORAMA, eye, axes) }
            }
            CameraFrame::Fisheye(Fisheye { eye, axes, middle, turns_per_pixel }) => {
                Self { lens_x: middle.extend(turns_per_pixel), ..of_axes(LENS_FISHEYE, eye, axes) }
            }
        }
    }

    /// The same input with these lines.
    fn with_lines(self, lines: &Lines) -> Self {
        const NONE: Line = Line { width: 0.0, color: Vec3::ZERO };
        let edges = lines.edges.unwrap_or(NONE);
        let grid = lines.grid.unwrap_or(GridLines { line: NONE, spacing: 1 });
        Self {
            edge_color: edges.color,
            edge_width: edges.width,
            grid_color: grid.line.color,
            grid_width: grid.line.width,
            grid_spacing: grid.spacing,
            ..self
        }
    }
}

/// Numbers of the constants that shaders are specialized with.
pub mod constant {
    /// Whether decisions too near to a plane for plain floats are made exactly.
    pub const EXACT: u32 = 0;
    /// Whether there is one instance that stands where its grid is.
    pub const IS_SINGLE: u32 = 1;
    /// What the primitives of acceleration structures are.
    pub const PRIMITIVE: u32 = 2;
    /// The `top_shift` of all grids, 0 where they differ.
    pub const TOP_SHIFT: u32 = 3;
    /// Whether the cells of bricks say which of their blocks hold a voxel.
    pub const CELLS_HAVE_BLOCKS: u32 = 4;
    /// The lens of camera rays, one of `LENS_`.
    pub const LENS: u32 = 5;
    /// The sky, one of `SKY_`.
    pub const SKY: u32 = 6;
    /// Whether there are cuts.
    pub const CUTS: u32 = 7;
    /// Whether the ground shows shadows alone.
    pub const CATCHER: u32 = 8;
    /// Whether there are lines on the faces of voxels.
    pub const LINES: u32 = 9;
    /// Whether voxels have normals.
    pub const NORMALS: u32 = 10;
    /// Whether empty cells say how many cells a ray may skip, as those of the processor do.
    pub const SKIPS: u32 = 11;
    /// Whether cells, bricks and materials lie in pages.
    pub const PAGES: u32 = 12;
}
