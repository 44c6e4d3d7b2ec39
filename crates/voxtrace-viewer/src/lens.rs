//! Choosing and setting the lens of the camera, as the options of `render` about lenses do (`docs/decisions/0046-lenses.md`).

use crate::navigation::Motion;
use crate::session::Session;
use crate::tr;
use voxtrace::Camera;
use voxtrace::camera::Lens;
use voxtrace::glam::{Vec2, Vec3};

/// Direction from what is looked at to the eye of an isometric view: that of `render --projection isometric`.
const ISOMETRIC: Vec3 = Vec3::new(1.0, -1.0, 1.0);
/// Radius of the first aperture, as a share of the distance in focus: what is far away is blurred by a fortieth of the picture's height.
const FIRST_APERTURE: f32 = 0.01;
/// Degrees of the field of view that stand for twice the height of a view with parallel rays.
const DOUBLE: f32 = 20.0;
/// Angles of a fisheye that can be chosen, degrees.
pub const FISHEYE_ANGLES: std::ops::RangeInclusive<f32> = 10.0..=360.0;

/// What can be chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LensChoice {
    /// Everything is in focus.
    Pinhole,
    /// One distance is in focus.
    ThinLens,
    /// Parallel rays.
    Orthographic,
    /// Parallel rays, seen from a corner.
    Isometric,
    /// All directions.
    Panorama,
    /// A wide angle.
    Fisheye,
}

impl LensChoice {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Pinhole, Self::ThinLens, Self::Orthographic, Self::Isometric, Self::Panorama, Self::Fisheye];

    /// What it is, for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pinhole => tr!("lens.pinhole"),
            Self::ThinLens => tr!("lens.thin"),
            Self::Orthographic => tr!("lens.orthographic"),
            Self::Isometric => tr!("lens.isometric"),
            Self::Panorama => tr!("lens.panorama"),
            Self::Fisheye => tr!("lens.fisheye"),
        }
    }

    /// The lens of a camera.
    pub fn of(camera: &Camera) -> Self {
        match camera.lens.name() {
            "thin-lens" => Self::ThinLens,
            "orthographic" if is_isometric(camera) => Self::Isometric,
            "orthographic" => Self::Orthographic,
            "panorama" => Self::Panorama,
            "fisheye" => Self::Fisheye,
            _ => Self::Pinhole,
        }
    }

    /// Name of the lens in files and options: constant, as what it is for people is another in each language.
    const fn lens(self) -> &'static str {
        match self {
            Self::Pinhole => "pinhole",
            Self::ThinLens => "thin-lens",
            Self::Orthographic | Self::Isometric => "orthographic",
            Self::Panorama => "panorama",
            Self::Fisheye => "fisheye",
        }
    }
}

fn is_isometric(camera: &Camera) -> bool {
    camera.axes().forward.dot(-ISOMETRIC.normalize()) > 1.0 - 1e-5
}

impl Session {
    /// Looks through another lens, so that what is in the middle of the picture stays there and as large as it is.
    pub fn choose_lens(&mut self, choice: LensChoice) {
        let old = self.navigator.camera().clone();
        if choice == LensChoice::of(&old) {
            return;
        }
        let middle = self.middle();
        let mut camera = old.clone();
        if let Lens::Orthographic { view_height } = old.lens
            && matches!(choice, LensChoice::Pinhole | LensChoice::ThinLens)
        {
            let at_one = Camera { target: old.eye + old.axes().forward, ..old.clone() }.height_at_target();
            camera.eye = middle - old.axes().forward * (view_height / at_one);
            camera.target = middle;
        }
        if choice == LensChoice::Isometric {
            camera.eye = middle + ISOMETRIC.normalize() * old.eye.distance(middle);
            (camera.target, camera.up) = (middle, Vec3::Z);
        }
        let depth = camera.focus_on(middle);
        self.lens_settings.extend(old.lens.settings());
        let kept = |key: &str| self.lens_settings.get(key).copied();
        let setting = |key: &str| match key {
            "aperture" => kept(key).or(Some(depth * FIRST_APERTURE)),
            "focus" => Some(depth),
            "view_height" => match old.lens {
                Lens::Orthographic { view_height } => Some(view_height),
                _ => Some(
                    Camera { target: camera.eye + camera.axes().forward * depth, ..camera.clone() }.height_at_target(),
                ),
            },
            _ => kept(key),
        };
        match Lens::from_settings(choice.lens(), setting) {
            Ok(lens) => self.move_by(Motion::GoTo(camera.with_lens(lens))),
            Err(error) => self.say(error, true),
        }
    }

    /// Focuses on what is under the cursor. A pinhole, which shows all of it sharp, becomes a thin lens.
    pub fn focus_at(&mut self, cursor: Option<Vec2>) {
        match cursor.and_then(|cursor| self.pick(cursor)) {
            Some(picked) => self.focus_on(picked.point),
            None => self.say(tr!("said.there_is_nothing_to_focus_on"), false),
        }
    }

    /// Focuses on a point of the world likewise.
    pub fn focus_on(&mut self, point: Vec3) {
        if self.navigator.camera().lens == Lens::Pinhole {
            self.choose_lens(LensChoice::ThinLens);
        }
        let camera = self.navigator.camera();
        let Lens::Thin { aperture, blades, blade_rotation, .. } = camera.lens else {
            return self.say(tr!("lens.no_focus", name = camera.lens.name()), false);
        };
        let lens = Lens::Thin { focus: camera.focus_on(point), aperture, blades, blade_rotation };
        match lens.check() {
            Ok(()) => self.move_by(Motion::Lens(lens)),
            Err(error) => self.say(error, false),
        }
    }

    /// What the picture shows in its middle; the camera's target where that is nothing.
    pub(crate) fn middle(&self) -> Vec3 {
        let (width, height) = self.size();
        let picked = self.pick(Vec2::new(width as f32, height as f32) * 0.5);
        picked.map_or(self.navigator.camera().target, |picked| picked.point)
    }

    /// Shows more, by so many degrees or, where rays are parallel, as much more as suits them.
    pub fn widen(&mut self, degrees: f32) {
        let camera = self.navigator.camera();
        let motion = match camera.lens {
            Lens::Orthographic { view_height } => {
                Motion::Lens(Lens::Orthographic { view_height: view_height * (degrees / DOUBLE).exp2() })
            }
            Lens::Fisheye { fisheye_angle } => {
                let (least, most) = FISHEYE_ANGLES.into_inner();
                Motion::Lens(Lens::Fisheye { fisheye_angle: (fisheye_angle + degrees).clamp(least, most) })
            }
            Lens::Panorama { .. } => return self.say(tr!("said.a_panorama_shows_all_directions"), false),
            _ => Motion::FieldOfView(camera.fov_y + degrees),
        };
        self.move_by(motion);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_choice_has_the_name_of_its_lens_in_files_whatever_language_is_spoken() {
        const NAMES: [&str; 6] = {
            let mut names = [""; 6];
            let mut index = 0;
            while index < names.len() {
                names[index] = LensChoice::ALL[index].lens();
                index += 1;
            }
            names
        };
        for (choice, name) in LensChoice::ALL.into_iter().zip(NAMES) {
            let lens = Lens::from_settings(name, |_| Some(10.0)).unwrap();
            let camera = Camera::look_at(ISOMETRIC, Vec3::ZERO).with_lens(lens);
            let of_camera = LensChoice::of(&camera);
            assert_eq!(of_camera, if choice == LensChoice::Orthographic { LensChoice::Isometric } else { choice });
        }
    }
}
