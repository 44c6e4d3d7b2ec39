//! A flight through cameras: a smooth path through their poses, flown at constant speed or by times. The path is made of cubic Bézier curves
//! where cameras have handles, else it is the spline of Catmull and Rom (1974)
//! with centripetal knots (Yuksel, Schaefer and Keyser, "Parameterization and applications of Catmull-Rom curves", 2011), which has
//! neither loops nor cusps between two cameras; directions are unit quaternions on the same spline, brought back to unit length.
//!
//! Only + − × ÷ √ in double precision: the same cameras give the same frames on every machine.

use super::pose::Pose;
use super::{Camera, Handles, Lens};

/// Pieces of a leg between two cameras, within which speed is taken to be even.
const PIECES: usize = 256;
/// Share that turning has in the length of a flight, beside moving: a camera that turns on the spot takes its time too.
const TURNING: f64 = 0.25;

/// A path through cameras.
#[derive(Clone, Debug)]
pub struct Flight {
    first: Camera,
    last: Camera,
    keys: Vec<Pose>,
    /// Lens of each key.
    lenses: Vec<Lens>,
    /// Change of the pose with the knots' unit where the path arrives at each key, and where it leaves.
    tangents: Vec<[Pose; 2]>,
    /// Knots' units of each leg.
    legs: Vec<f64>,
    /// Length of the path up to each piece, and at its end; where cameras have times, those.
    lengths: Vec<f64>,
}

impl Flight {
    /// The flight through `cameras`, in this order. Two of them, one after the other, that see the same are one; two in one place whose thin lenses
    /// are set otherwise see something else.
    ///
    /// # Errors
    /// Says what is wrong: fewer than two cameras, or one that cannot send rays.
    pub fn through(cameras: &[Camera]) -> Result<Self, &'static str> {
        Self::through_with(cameras, &vec![Handles::default(); cameras.len()])
    }

    /// As [`Self::through`], on Bézier curves with the handles of each camera.
    ///
    /// # Errors
    /// As [`Self::through`]; also those of [`Handles::check`], or where there are not as many as cameras.
    pub fn through_with(cameras: &[Camera], handles: &[Handles]) -> Result<Self, &'static str> {
        cameras.iter().try_for_each(Camera::check)?;
        check(handles, cameras.len())?;
        let (Some(first), Some(last)) = (cameras.first(), cameras.last()) else { return Err(FEW) };
        let (mut keys, mut lenses): (Vec<Pose>, Vec<Lens>) = (Vec::new(), Vec::new());
        let mut of_keys: Vec<Handles> = Vec::new();
        for (camera, own) in cameras.iter().zip(handles) {
            let pose = keys.last().map_or_else(|| Pose::of(camera), |before| Pose::of(camera).beside(before));
            // In one place something else may come into focus.
            let is_same = keys.last() == Some(&pose) && !pulls_focus(&first.lens, lenses.last(), &camera.lens);
            match of_keys.last_mut().filter(|_| is_same) {
                Some(before) => *before = Handles { arriving: before.arriving, ..*own },
                None => {
                    keys.push(pose);
                    lenses.push(camera.lens);
                    of_keys.push(*own);
                }
            }
        }
        if keys.len() < 2 {
            return Err(FEW);
        }
        let sum = |of: &dyn Fn(&Pose, &Pose) -> f64| keys.windows(2).map(|pair| of(&pair[0], &pair[1])).sum::<f64>();
        let (way, turning) = (sum(&|one, other| one.eye().distance(other.eye())), sum(&Pose::angle));
        let radius = if way > 0.0 && turning > 0.0 { TURNING * way / turning } else { 1.0 };
        // Where only the field of view or the focus changes, there is no way: such legs take as long as the shortest that there are.
        let ways: Vec<f64> = keys.windows(2).map(|pair| pair[0].distance(&pair[1], radius)).collect();
        let shortest = ways.iter().copied().filter(|&way| way > 0.0).fold(f64::INFINITY, f64::min);
        let shortest = if shortest.is_finite() { shortest } else { 1.0 };
        let legs: Vec<f64> = ways.iter().map(|&way| if way > 0.0 { way } else { shortest }.sqrt()).collect();
        let tangents = tangents(&keys, &legs, &of_keys);
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
        Self::timed_with(cameras, &vec![Handles::default(); cameras.len()])
    }

    /// As [`Self::timed`], on Bézier curves with the handles of each camera.
    ///
    /// # Errors
    /// As [`Self::timed`]; also those of [`Handles::check`], or where there are not as many as cameras.
    pub fn timed_with(cameras: &[(f64, Camera)], handles: &[Handles]) -> Result<Self, &'static str> {
        cameras.iter().try_for_each(|(_, camera)| camera.check())?;
        check(handles, cameras.len())?;
        let [(_, first), .., (_, last)] = cameras else { return Err("a flight leads through two cameras or more") };
        let mut keys: Vec<Pose> = Vec::with_capacity(cameras.len());
        for (_, camera) in cameras {
            keys.push(keys.last().map_or_else(|| Pose::of(camera), |before| Pose::of(camera).beside(before)));
        }
        let legs: Vec<f64> = cameras.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
        if !legs.iter().all(|&leg| leg > 0.0 && leg.is_finite()) {
            return Err("the times of the cameras do not rise");
        }
        let tangents = tangents(&keys, &legs, handles);
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
        let share = place - leg as f64;
        // The end is its own number, whatever the difference was rounded to.
        let mix = |from: f32, to: f32| match share < 1.0 {
            true => (f64::from(from) + f64::from(to - from) * share) as f32,
            false => to,
        };
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
            .plus(&self.tangents[leg][1], (t3 - 2.0 * t2 + t) * unit)
            .plus(&self.keys[leg + 1], 3.0 * t2 - 2.0 * t3)
            .plus(&self.tangents[leg + 1][0], (t3 - t2) * unit)
    }
}

/// Why there is no flight.
const FEW: &str = "a flight leads through two cameras or more that differ";

/// Whether aperture or focus change from one camera to the next, in a flight whose lens is that of its first camera.
fn pulls_focus(first: &Lens, before: Option<&Lens>, lens: &Lens) -> bool {
    let setting = |lens: &Lens| match *lens {
        Lens::Thin { aperture, focus, .. } => Some((aperture, focus)),
        _ => None,
    };
    let pair = setting(first).and(before).and_then(setting).zip(setting(lens));
    pair.is_some_and(|(before, now)| before != now)
}

/// Whether handles are sound, and as many as cameras.
fn check(handles: &[Handles], cameras: usize) -> Result<(), &'static str> {
    if handles.len() != cameras {
        return Err("there are not as many handles as cameras");
    }
    handles.iter().try_for_each(Handles::check)
}

/// The tangents of Catmull and Rom's spline with uneven knots; at the ends those of the straight leg. Of the eye those of the handles.
fn tangents(keys: &[Pose], legs: &[f64], handles: &[Handles]) -> Vec<[Pose; 2]> {
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
    let with_handles = |key: usize| {
        let (before, after) = (key.checked_sub(1).map_or(0.0, |leg| legs[leg]), legs.get(key).copied().unwrap_or(0.0));
        handles[key].tangents(before, after).map(|eye| tangent(key).with_eye(eye))
    };
    let mut tangents: Vec<[Pose; 2]> = (0..keys.len()).map(with_handles).collect();
    for (key, both) in tangents.iter_mut().enumerate() {
        let is_free = [handles[key].arriving, handles[key].leaving].map(|handle| handle.is_none());
        for part in Pose::PARTS {
            let same =
                |other: Option<&Pose>| other.is_some_and(|other| other.0[part.clone()] == keys[key].0[part.clone()]);
            // What two cameras have in common rests between them: one that only turns stays in its place.
            let rests = same(key.checked_sub(1).map(|before| &keys[before])) || same(keys.get(key + 1));
            for side in (0..2).filter(|&side| rests && (part.start > 0 || is_free[side])) {
                both[side].0[part.clone()].fill(0.0);
            }
        }
    }
    tangents
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
    fn a_flight_with_handles_is_made_of_bezier_curves_without_corners() {
        let cameras = around();
        let handle = |x: f32, y: f32, z: f32| Some(Vec3::new(x, y, z));
        let handles = [
            Handles { leaving: handle(20.0, 30.0, 0.0), ..Handles::default() },
            Handles { leaving: handle(-30.0, 10.0, 5.0), ..Handles::default() },
            Handles { arriving: handle(0.0, 20.0, 0.0), leaving: handle(0.0, -35.0, 0.0), is_corner: false },
            Handles { arriving: handle(-9.0, 2.0, 1.0), ..Handles::default() },
        ];
        let times = [0.0, 1.0, 2.0, 4.0];
        let keys: Vec<(f64, Camera)> = times.into_iter().zip(cameras.iter().cloned()).collect();
        let timed = Flight::timed_with(&keys, &handles).unwrap();
        // By de Casteljau's construction: lines between the control points, between those, and between those.
        let mirrored = [None, handle(30.0, -10.0, -5.0), handles[2].arriving, handles[3].arriving];
        for leg in 0..3 {
            let ends = [cameras[leg].eye, cameras[leg + 1].eye];
            let mut points =
                vec![ends[0], ends[0] + handles[leg].leaving.unwrap(), ends[1] + mirrored[leg + 1].unwrap(), ends[1]];
            let share = 0.3f32;
            while points.len() > 1 {
                points = points.windows(2).map(|pair| pair[0].lerp(pair[1], share)).collect();
            }
            let time = times[leg] + f64::from(share) * (times[leg + 1] - times[leg]);
            let eye = timed.at(time / 4.0).eye;
            assert!(eye.abs_diff_eq(points[0], 1e-3), "{leg}: {eye} {}", points[0]);
            assert!(!Flight::timed(&keys).unwrap().at(time / 4.0).eye.abs_diff_eq(points[0], 1.0), "{leg}");
        }
        let flight = Flight::through_with(&cameras, &handles).unwrap();
        let eyes: Vec<Vec3> = (1..=2000).map(|frame| flight.frame(frame, 2000).eye).collect();
        let bend = |eyes: &[Vec3]| {
            let turn = |three: &[Vec3]| (three[1] - three[0]).normalize().dot((three[2] - three[1]).normalize());
            eyes.windows(3).map(turn).fold(1f32, f32::min)
        };
        assert!(bend(&eyes) > 0.99, "{}", bend(&eyes));
        let speeds = speeds(&flight, 401);
        let (least, most) = speeds.iter().fold((f32::MAX, 0f32), |(least, most), &v| (least.min(v), most.max(v)));
        assert!(most / least < 1.6, "{least} to {most}: turning has its share, too");
        // A corner is a fault, and is seen where it is wanted.
        let mut bent = handles;
        bent[2].arriving = handle(20.0, 0.0, 0.0);
        assert!(Flight::through_with(&cameras, &bent).is_err());
        bent[2].is_corner = true;
        let corner = Flight::through_with(&cameras, &bent).unwrap();
        assert!(bend(&(1..=2000).map(|frame| corner.frame(frame, 2000).eye).collect::<Vec<_>>()) < 0.9);
        assert!(Flight::through_with(&cameras, &handles[1..]).is_err());
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
        // Numbers whose difference is rounded: the ends are the cameras' own, to the bit.
        cameras[0].lens = thin(10.1, 0.7);
        cameras[1].lens = thin(0.3, 9.1);
        let flight = Flight::through(&cameras).unwrap();
        assert_eq!((flight.at(0.0), flight.at(1.0)), (cameras[0].clone(), cameras[1].clone()));
    }

    #[test]
    fn a_focus_is_pulled_where_the_camera_stands_still() {
        let thin = |focus| Lens::Thin { aperture: 1.0, focus, blades: 0, blade_rotation: 0.0 };
        let stops = [around()[0].clone(), around()[1].clone(), around()[1].clone(), around()[2].clone()];
        let cameras: Vec<Camera> = stops
            .into_iter()
            .zip([9.0, 10.0, 50.0, 52.0])
            .map(|(camera, focus)| camera.with_lens(thin(focus)))
            .collect();
        let focus = |camera: &Camera| match camera.lens {
            Lens::Thin { focus, .. } => focus,
            _ => panic!("{camera:?}"),
        };
        let frames = |cameras: &[Camera]| {
            let flight = Flight::through(cameras).unwrap();
            (1..=301).map(|frame| flight.frame(frame, 301)).collect::<Vec<_>>()
        };
        let all = frames(&cameras);
        let still: Vec<&Camera> = all.iter().filter(|camera| (10.5..49.5).contains(&focus(camera))).collect();
        // Of three legs, this takes as long as the shorter one of the others.
        assert!(still.len() > 60, "{}", still.len());
        assert!(still.iter().all(|camera| camera.eye.abs_diff_eq(cameras[1].eye, 1e-3)));
        assert!(
            all.windows(2).all(|pair| focus(&pair[1]) >= focus(&pair[0]) && focus(&pair[1]) - focus(&pair[0]) < 1.0)
        );
        // Nothing but that, on the spot.
        let alone = frames(&cameras[1..3]);
        assert!((focus(&alone[150]) - 30.0).abs() < 0.1, "{}", focus(&alone[150]));
        // Pinholes have nothing to pull: both stops are one.
        let pinholes: Vec<Camera> = cameras.iter().map(|camera| camera.clone().with_lens(Lens::Pinhole)).collect();
        let moving = frames(&pinholes);
        assert!(moving.windows(2).all(|pair| pair[0].eye != pair[1].eye));
        assert_eq!(Flight::through(&pinholes[1..3]).unwrap_err(), FEW);
    }

    #[test]
    fn a_camera_that_turns_or_zooms_between_two_ways_stays_in_its_place() {
        let place = [0.0, 50.0, 8.0];
        let turns = [
            camera([0.0, 0.0, 8.0], [0.0, 90.0, 8.0], 45.0),
            camera(place, [0.0, 90.0, 8.0], 45.0),
            camera(place, [90.0, 50.0, 8.0], 45.0),
            camera(place, [90.0, 50.0, 8.0], 30.0),
            camera([60.0, 50.0, 20.0], [90.0, 50.0, 8.0], 30.0),
        ];
        let keys: Vec<(f64, Camera)> = (0..5).map(f64::from).zip(turns.iter().cloned()).collect();
        let timed = Flight::timed(&keys).unwrap();
        for step in 0..=40 {
            let seen = timed.at((1.0 + f64::from(step) / 20.0) / 4.0);
            assert!(seen.eye.abs_diff_eq(place.into(), 1e-4), "{step}: {}", seen.eye);
            assert!(step > 20 || (seen.fov_y - 45.0).abs() < 1e-4, "{step}: {}", seen.fov_y);
        }
        assert!(!timed.at(0.9).eye.abs_diff_eq(place.into(), 1.0), "the comparison sees another place");
        let flight = Flight::through(&turns).unwrap();
        let frames: Vec<Camera> = (1..=400).map(|frame| flight.frame(frame, 400)).collect();
        let is_there = |camera: &&Camera| camera.eye.abs_diff_eq(place.into(), 1e-4);
        assert!(frames.iter().filter(is_there).count() > 50);
        // On its way there it never gets past.
        assert!(frames.iter().all(|camera| camera.eye.y < 50.0 + 1e-3));
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
