//! A flight through cameras: a smooth path through their poses, flown at constant speed. The path is the spline of Catmull and Rom (1974)
//! with centripetal knots (Yuksel, Schaefer and Keyser, "Parameterization and applications of Catmull-Rom curves", 2011), which has
//! neither loops nor cusps between two cameras; directions are unit quaternions on the same spline, brought back to unit length.
//!
//! Only + − × ÷ √ in double precision: the same cameras give the same frames on every machine.

use super::{Camera, Lens};
use glam::{DMat3, DQuat, DVec3};

/// Pieces of a leg between two cameras, within which speed is taken to be even.
const PIECES: usize = 256;
/// Share that turning has in the length of a flight, beside moving: a camera that turns on the spot takes its time too.
const TURNING: f64 = 0.25;
/// Sine of the angle between view and `up` below which `up` says nothing.
const STEEP: f64 = 1e-3;

/// A path through cameras.
#[derive(Clone, Debug)]
pub struct Flight {
    first: Camera,
    last: Camera,
    keys: Vec<Pose>,
    /// Lens of each key.
    lenses: Vec<Lens>,
    /// Change of the pose with the knots' unit at each key.
    tangents: Vec<Pose>,
    /// Knots' units of each leg.
    legs: Vec<f64>,
    /// Length of the path up to each piece, and at its end; where cameras have times, those.
    lengths: Vec<f64>,
}

/// A camera as numbers that can be interpolated: eye, quaternion, up, distance of the target, field of view.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Pose([f64; 12]);

impl Pose {
    fn of(camera: &Camera) -> Self {
        let eye = camera.eye.as_dvec3();
        let offset = camera.target.as_dvec3() - eye;
        let forward = offset.normalize_or(DVec3::Y);
        // Along `up` the picture has the side that the projection takes.
        let side = forward.cross(camera.up.as_dvec3()).try_normalize();
        let right = side.unwrap_or_else(|| forward.as_vec3().any_orthonormal_vector().as_dvec3());
        let turn = DQuat::from_mat3(&DMat3::from_cols(right, forward, right.cross(forward)));
        let up = camera.up.as_dvec3().normalize_or(DVec3::Z);
        let distance = offset.length();
        let fov_y = f64::from(camera.fov_y);
        Self([eye.x, eye.y, eye.z, turn.x, turn.y, turn.z, turn.w, up.x, up.y, up.z, distance, fov_y])
    }

    fn eye(&self) -> DVec3 {
        DVec3::from_slice(&self.0[..3])
    }

    fn turn(&self) -> DQuat {
        DQuat::from_slice(&self.0[3..7]).normalize()
    }

    /// With the one of both quaternions of its direction that is nearer to another pose's.
    fn beside(mut self, other: &Self) -> Self {
        let dot: f64 = (3..7).map(|index| self.0[index] * other.0[index]).sum();
        if dot < 0.0 {
            self.0[3..7].iter_mut().for_each(|part| *part = -*part);
        }
        self
    }

    /// Each number of both, combined.
    fn zip(&self, other: &Self, combine: impl Fn(f64, f64) -> f64) -> Self {
        Self(std::array::from_fn(|index| combine(self.0[index], other.0[index])))
    }

    fn plus(&self, other: &Self, factor: f64) -> Self {
        self.zip(other, |own, other| own + other * factor)
    }

    fn scaled(&self, factor: f64) -> Self {
        Self(self.0.map(|value| value * factor))
    }

    /// How far it is to another pose; `radius` is the length of a radian of turning.
    fn distance(&self, other: &Self, radius: f64) -> f64 {
        (self.eye().distance_squared(other.eye()) + (radius * self.angle(other)).powi(2)).sqrt()
    }

    /// The chord of the turning between two poses, which is its angle where that is small.
    fn angle(&self, other: &Self) -> f64 {
        let (own, other) = (self.turn(), other.turn());
        2.0 * (own - other).length().min((own + other).length())
    }

    /// The camera, within the fields of view and distances that the cameras of the flight have.
    fn camera(&self, fields: (f64, f64), distances: (f64, f64)) -> Camera {
        let (eye, turn) = (self.eye(), self.turn());
        let forward = turn * DVec3::Y;
        let up = DVec3::from_slice(&self.0[7..10]).normalize_or(DVec3::Z);
        let up = if forward.cross(up).length() < STEEP { turn * DVec3::Z } else { up };
        Camera {
            name: "flight".into(),
            eye: eye.as_vec3(),
            target: (eye + forward * self.0[10].clamp(distances.0, distances.1)).as_vec3(),
            up: up.as_vec3(),
            fov_y: self.0[11].clamp(fields.0, fields.1) as f32,
            lens: Lens::Pinhole,
        }
    }
}

impl Flight {
    /// The flight through `cameras`, in this order. Two of them, one after the other, that see the same are one.
    ///
    /// # Errors
    /// Says what is wrong: fewer than two cameras, or one that cannot send rays.
    pub fn through(cameras: &[Camera]) -> Result<Self, &'static str> {
        cameras.iter().try_for_each(Camera::check)?;
        let (Some(first), Some(last)) = (cameras.first(), cameras.last()) else { return Err(FEW) };
        let (mut keys, mut lenses): (Vec<Pose>, Vec<Lens>) = (Vec::new(), Vec::new());
        for camera in cameras {
            let pose = keys.last().map_or_else(|| Pose::of(camera), |before| Pose::of(camera).beside(before));
            if keys.last() != Some(&pose) {
                keys.push(pose);
                lenses.push(camera.lens);
            }
        }
        if keys.len() < 2 {
            return Err(FEW);
        }
        let sum = |of: &dyn Fn(&Pose, &Pose) -> f64| keys.windows(2).map(|pair| of(&pair[0], &pair[1])).sum::<f64>();
        let (way, turning) = (sum(&|one, other| one.eye().distance(other.eye())), sum(&Pose::angle));
        let radius = if way > 0.0 && turning > 0.0 { TURNING * way / turning } else { 1.0 };
        // Where only the field of view changes, there is no way: such legs take as long as the shortest that there are.
        let ways: Vec<f64> = keys.windows(2).map(|pair| pair[0].distance(&pair[1], radius)).collect();
        let shortest = ways.iter().copied().filter(|&way| way > 0.0).fold(f64::INFINITY, f64::min);
        let shortest = if shortest.is_finite() { shortest } else { 1.0 };
        let legs: Vec<f64> = ways.iter().map(|&way| if way > 0.0 { way } else { shortest }.sqrt()).collect();
        let tangents = tangents(&keys, &legs);
        let (first, last) = (first.clone(), last.clone());
        let mut flight = Self { first, last, keys, lenses, tangents, legs, lengths: vec![0.0] };
        let mut before = flight.keys[0];
        let mut length = 0.0;
        for piece in 1..=flight.legs.len() * PIECES {
            let pose = flight.pose(piece as f64 / PIECES as f64);
            let least = if ways[(piece - 1) / PIECES] > 0.0 { 0.0 } else { shortest / PIECES as f64 };
            length += before.distance(&pose, radius).max(least);
            flight.lengths.push(length);
            before = pose;
        }
        Ok(flight)
    }

    /// The flight that is at each camera at its time, in seconds; shares of the way are those of the time between the first and the last.
    ///
    /// # Errors
    /// Says what is wrong: fewer than two cameras, times that do not rise, or a camera that cannot send rays.
    pub fn timed(cameras: &[(f64, Camera)]) -> Result<Self, &'static str> {
        cameras.iter().try_for_each(|(_, camera)| camera.check())?;
        let [(_, first), .., (_, last)] = cameras else { return Err("a flight leads through two cameras or more") };
        let mut keys: Vec<Pose> = Vec::with_capacity(cameras.len());
        for (_, camera) in cameras {
            keys.push(keys.last().map_or_else(|| Pose::of(camera), |before| Pose::of(camera).beside(before)));
        }
        let legs: Vec<f64> = cameras.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
        if !legs.iter().all(|&leg| leg > 0.0 && leg.is_finite()) {
            return Err("the times of the cameras do not rise");
        }
        let mut tangents = tangents(&keys, &legs);
        for (key, tangent) in tangents.iter_mut().enumerate() {
            // Who stays for a while stands still then.
            let stays = (key > 0 && keys[key - 1] == keys[key]) || keys.get(key + 1) == Some(&keys[key]);
            *tangent = if stays { tangent.scaled(0.0) } else { *tangent };
        }
        let (first, last) = (first.clone(), last.clone());
        let lenses = cameras.iter().map(|(_, camera)| camera.lens).collect();
        let mut lengths = vec![0.0];
        let mut before = 0.0;
        for &leg in &legs {
            lengths.extend((1..=PIECES).map(|piece| before + leg * piece as f64 / PIECES as f64));
            before += leg;
        }
        Ok(Self { first, last, keys, lenses, tangents, legs, lengths })
    }

    /// The camera after this share of the way, from 0 to 1; at the ends those of the flight, to the bit. All
    /// have the lens of the first, with apertures and distances in focus that change evenly from one thin lens to the next.
    pub fn at(&self, share: f64) -> Camera {
        if share.is_nan() || share <= 0.0 {
            return self.first.clone();
        }
        if share >= 1.0 {
            return self.last.clone().with_lens(self.lens(self.legs.len() as f64));
        }
        let length = share * self.lengths[self.lengths.len() - 1];
        let piece = self.lengths.partition_point(|&end| end <= length).clamp(1, self.lengths.len() - 1);
        let (start, end) = (self.lengths[piece - 1], self.lengths[piece]);
        let within = if end > start { (length - start) / (end - start) } else { 0.0 };
        let range = |index: usize| {
            let values = self.keys.iter().map(|key| key.0[index]);
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)))
        };
        let place = ((piece - 1) as f64 + within) / PIECES as f64;
        self.pose(place).camera(range(11), range(10)).with_lens(self.lens(place))
    }

    /// The lens at a place, as [`Self::pose`] counts.
    fn lens(&self, place: f64) -> Lens {
        let leg = (place as usize).min(self.legs.len() - 1);
        let mix = |from: f32, to: f32| (f64::from(from) + f64::from(to - from) * (place - leg as f64)) as f32;
        match (self.first.lens, self.lenses[leg], self.lenses[leg + 1]) {
            (
                Lens::Thin { blades, blade_rotation, .. },
                Lens::Thin { aperture: from, focus: near, .. },
                Lens::Thin { aperture: to, focus: far, .. },
            ) => Lens::Thin { aperture: mix(from, to), focus: mix(near, far), blades, blade_rotation },
            (first, ..) => first,
        }
    }

    /// The camera of frame `frame` of `frames`, counted from 1: the first is the flight's first camera, the last its last.
    pub fn frame(&self, frame: u32, frames: u32) -> Camera {
        self.at(f64::from(frame.saturating_sub(1)) / f64::from(frames.saturating_sub(1).max(1)))
    }

    /// The pose at `place`: the whole part is the leg, the rest the share of its knots' units.
    fn pose(&self, place: f64) -> Pose {
        let leg = (place as usize).min(self.legs.len() - 1);
        let (unit, t) = (self.legs[leg], place - leg as f64);
        let (t2, t3) = (t * t, t * t * t);
        self.keys[leg]
            .scaled(2.0 * t3 - 3.0 * t2 + 1.0)
            .plus(&self.tangents[leg], (t3 - 2.0 * t2 + t) * unit)
            .plus(&self.keys[leg + 1], 3.0 * t2 - 2.0 * t3)
            .plus(&self.tangents[leg + 1], (t3 - t2) * unit)
    }
}

/// Why there is no flight.
const FEW: &str = "a flight leads through two cameras or more, in different places";

/// The tangents of Catmull and Rom's spline with uneven knots; at the ends those of the straight leg.
fn tangents(keys: &[Pose], legs: &[f64]) -> Vec<Pose> {
    let slope = |leg: usize| keys[leg + 1].plus(&keys[leg], -1.0).scaled(1.0 / legs[leg]);
    let tangent = |key: usize| match key {
        0 => slope(0),
        last if last == legs.len() => slope(last - 1),
        key => {
            let (before, after) = (legs[key - 1], legs[key]);
            let across = keys[key + 1].plus(&keys[key - 1], -1.0).scaled(1.0 / (before + after));
            slope(key - 1).plus(&slope(key), 1.0).plus(&across, -1.0)
        }
    };
    (0..keys.len()).map(tangent).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    fn camera(eye: [f32; 3], target: [f32; 3], fov_y: f32) -> Camera {
        Camera { fov_y, ..Camera::look_at(eye.into(), target.into()) }
    }

    fn around() -> Vec<Camera> {
        let eyes = [[40.0, 0.0, 9.0], [0.0, 30.0, 2.0], [-25.0, 0.0, 14.0], [0.0, -60.0, 5.0]];
        eyes.map(|eye| camera(eye, [1.0, 2.0, 3.0], 45.0)).into()
    }

    fn speeds(flight: &Flight, frames: u32) -> Vec<f32> {
        let eye = |frame| flight.frame(frame, frames).eye;
        (1..frames).map(|frame| eye(frame).distance(eye(frame + 1))).collect()
    }

    #[test]
    fn a_flight_begins_and_ends_at_its_cameras_to_the_bit_and_passes_all_others() {
        let cameras = around();
        let flight = Flight::through(&cameras).unwrap();
        assert_eq!((flight.frame(1, 200), flight.frame(200, 200)), (cameras[0].clone(), cameras[3].clone()));
        for camera in &cameras {
            let nearest = (1..=2000).map(|frame| flight.frame(frame, 2000).eye.distance(camera.eye));
            assert!(nearest.fold(f32::MAX, f32::min) < 0.1, "{camera:?}");
        }
        let other = Flight::through(&cameras[1..]).unwrap();
        assert_ne!(flight.frame(2, 200), other.frame(2, 200), "the comparison sees another flight");
        assert_eq!(flight.frame(1, 1), cameras[0]);
    }

    #[test]
    fn a_flight_straight_on_has_one_speed_however_far_apart_its_cameras_are() {
        let eyes = [0.0, 1.0, 40.0, 43.0, 100.0];
        let cameras = eyes.map(|y| camera([5.0, y, 2.0], [5.0, y + 10.0, 2.0], 45.0));
        let speeds = speeds(&Flight::through(&cameras).unwrap(), 101);
        let (least, most) = speeds.iter().fold((f32::MAX, 0f32), |(least, most), &v| (least.min(v), most.max(v)));
        assert!(most / least < 1.01 && (speeds.iter().sum::<f32>() - 100.0).abs() < 0.1, "{least} to {most}");
    }

    #[test]
    fn a_flight_is_smooth_level_and_keeps_its_field_of_view_within_that_of_its_cameras() {
        let mut cameras = around();
        cameras[2].fov_y = 80.0;
        let flight = Flight::through(&cameras).unwrap();
        let frames: Vec<Camera> = (1..=400).map(|frame| flight.frame(frame, 400)).collect();
        for pair in frames.windows(3) {
            let steps = [pair[1].eye - pair[0].eye, pair[2].eye - pair[1].eye];
            assert!(steps[0].normalize().dot(steps[1].normalize()) > 0.99, "no corner");
            let view = |camera: &Camera| (camera.target - camera.eye).normalize();
            assert!(view(&pair[0]).dot(view(&pair[1])) > 0.998, "no sudden turn");
            assert!(pair[0].up.abs_diff_eq(Vec3::Z, 1e-6) && (45.0..=80.0).contains(&pair[0].fov_y));
            assert!(pair[0].check().is_ok());
        }
    }

    #[test]
    fn a_camera_may_turn_on_the_spot_zoom_and_look_straight_down() {
        let (here, there) = ([3.0, 4.0, 5.0], [3.0, 40.0, 5.0]);
        let cameras = [
            camera(here, there, 45.0),
            camera(here, there, 20.0),
            camera(here, [3.0, -40.0, 5.0], 20.0),
            camera(here, [3.0, 4.0, -30.0], 45.0),
            camera(here, [3.0, 4.0, -30.0], 45.0),
        ];
        let flight = Flight::through(&cameras).unwrap();
        for frame in 1..=300 {
            let camera = flight.frame(frame, 300);
            assert!(camera.eye.abs_diff_eq(here.into(), 1e-4) && camera.check().is_ok(), "{camera:?}");
            assert!((camera.target - camera.eye).normalize().cross(camera.up).length() > 0.0 || frame == 300);
        }
        assert!((20.5..44.5).contains(&flight.frame(20, 300).fov_y), "{}", flight.frame(20, 300).fov_y);
    }

    #[test]
    fn a_flight_with_times_is_at_its_cameras_then_and_stays_where_two_are_the_same() {
        let cameras = around();
        let keys: Vec<(f64, Camera)> = [0.0, 1.0, 3.0, 3.5].into_iter().zip(cameras.iter().cloned()).collect();
        let flight = Flight::timed(&keys).unwrap();
        for (time, camera) in &keys {
            assert!(flight.at(time / 3.5).eye.abs_diff_eq(camera.eye, 1e-3), "{time}");
        }
        assert!(!flight.at(2.0 / 3.5).eye.abs_diff_eq(cameras[1].eye, 1.0), "the comparison sees another place");
        let stays = [(0.0, &cameras[0]), (1.0, &cameras[1]), (2.0, &cameras[1]), (3.0, &cameras[2])];
        let flight = Flight::timed(&stays.map(|(time, camera)| (time, camera.clone()))).unwrap();
        assert!(
            (0..=10).all(|step| flight.at((1.0 + f64::from(step) / 10.0) / 3.0).eye.abs_diff_eq(cameras[1].eye, 1e-4))
        );
        assert!(Flight::timed(&keys[..1]).is_err() && Flight::timed(&[keys[1].clone(), keys[0].clone()]).is_err());
    }

    #[test]
    fn what_is_in_focus_changes_evenly_from_one_thin_lens_to_the_next() {
        let thin = |aperture, focus| Lens::Thin { aperture, focus, blades: 6, blade_rotation: 0.0 };
        let mut cameras = around();
        cameras.truncate(2);
        cameras[0].lens = thin(1.0, 10.0);
        cameras[1].lens = thin(3.0, 50.0);
        let keys = [(0.0, cameras[0].clone()), (2.0, cameras[1].clone())];
        let flight = Flight::timed(&keys).unwrap();
        assert_eq!((flight.at(0.5).lens, flight.at(1.0).lens), (thin(2.0, 30.0), thin(3.0, 50.0)));
    }

    #[test]
    fn fewer_than_two_places_are_no_flight() {
        let one = camera([0.0; 3], [1.0; 3], 45.0);
        for cameras in [vec![], vec![one.clone()], vec![one.clone(), one.clone()]] {
            assert_eq!(Flight::through(&cameras).unwrap_err(), FEW);
        }
        let broken = Camera { eye: Vec3::NAN, ..one.clone() };
        assert!(Flight::through(&[one, broken]).is_err());
    }
}
