//! Parts whose joints move each on its own, or whose morph targets have weights that change: their shapes at even steps of an animation. What is
//! kept of a shape is where the joints are and what the weights are; positions are made of that when they are asked for.

use super::Fault;
use super::accessor::Accessors;
use super::document::Primitive;
use super::morphs::{self, Target};
use super::moving::{Movers, Piece};
use super::primitives::{Source, packed, raised};
use super::scene::{Worn, local};
use super::skins::{Bound, Pose, Skins};
use glam::{DAffine3, DMat3, DVec3, Vec3};
use rustc_hash::FxHashMap;
use std::cell::RefCell;
use std::ops::Range;
use std::sync::Arc;
use voxtrace_voxelize::mesh::{ChangingPart, PartShapes};

/// Shapes a second, where nobody says how many.
const USUAL_RATE: f64 = 24.0;
/// Most steps of an animation, and most numbers that joints (12 each) and weights of all parts are at all of them: 200 MB.
const MOST_STEPS: usize = 1 << 16;
const MOST_NUMBERS: usize = 12 << 21;

/// When shapes are looked at.
#[derive(Clone, Copy)]
pub(super) struct Times {
    /// Steps a second; 0: there are none.
    pub rate: f64,
    /// How long the animation lasts, seconds.
    pub seconds: f64,
}

impl Times {
    /// Those of an animation of so many seconds, at the rate that is asked for.
    pub fn new(asked: Option<f64>, seconds: f64) -> Self {
        let rate = asked.filter(|rate| rate.is_finite() && *rate >= 0.0).unwrap_or(USUAL_RATE);
        Self { rate, seconds: seconds.max(0.0) }
    }

    /// The rate and the number of the times that there is room for, with so many numbers at each: the first is 0, the last one is not before the end.
    /// `None` where there is not room for two.
    fn fitting(self, numbers: usize) -> Option<(f64, usize)> {
        let most = (MOST_NUMBERS / numbers.max(1)).min(MOST_STEPS);
        if self.rate <= 0.0 || most < 2 {
            return None;
        }
        let all = (self.seconds * self.rate).ceil() + 1.0;
        if all <= most as f64 {
            return Some((self.rate, all as usize));
        }
        let rate = self.rate / (all / (most as f64 - 1.0)).ceil();
        Some((rate, ((self.seconds * rate).ceil() as usize).saturating_add(1).min(most))).filter(|_| rate > 0.0)
    }
}

/// What the shapes of a document are made of.
pub(super) struct Shaper<'a> {
    accessors: &'a Accessors<'a>,
    skins: &'a Skins,
    movers: &'a Movers,
    times: Times,
    /// How many numbers all parts that change have at a time.
    numbers: usize,
    /// Steps a second, and how many steps there are; `None`: what changes stays as at rest.
    steps: Option<(f64, usize)>,
    /// How many vertices of targets and joints are kept for parts so far.
    kept: u64,
}

/// The shapes of a part.
#[derive(Debug)]
struct Shapes {
    offset: DVec3,
    pieces: Vec<ShapedPiece>,
    shapes: Vec<Numbers>,
}

/// Vertices in a row of a part.
#[derive(Debug)]
struct ShapedPiece {
    positions: Vec<Vec3>,
    targets: Vec<Target>,
    /// How they follow joints, and which of the shape's these are.
    bound: Option<(Bound, Range<usize>)>,
    /// Which of the shape's weights they have.
    weights: Range<usize>,
    /// From the space of the mesh, or of the joints, to that of the part before its axes are ours.
    part_from_own: DAffine3,
}

/// The vertices of a primitive as they are before anything shapes them.
struct Unshaped {
    positions: Vec<Vec3>,
    targets: Vec<Target>,
    bound: Option<Bound>,
}

/// What tells a shape from others.
#[derive(Debug)]
struct Numbers {
    /// Of all poses, one after the other.
    joints: Vec<DAffine3>,
    /// Of all nodes, one after the other.
    weights: Vec<f64>,
}

/// What the pieces of a part follow.
#[derive(Default)]
struct Followed<'p> {
    poses: Vec<&'p Pose>,
    /// What has weights, and how many.
    weighted: Vec<(&'p Worn<'p>, usize)>,
    /// Of each piece which of the joints and of the weights.
    of_pieces: Vec<(Option<Range<usize>>, Range<usize>)>,
    /// How many joints and weights there are.
    joints: usize,
    weights: usize,
}

impl Numbers {
    /// The same for shapes that are the same but for rounding, as a rule.
    fn key(&self) -> Vec<u32> {
        let joints = self.joints.iter().flat_map(DAffine3::to_cols_array);
        // What is 0 has one sign.
        joints.chain(self.weights.iter().copied()).map(|number| (number as f32 + 0.0).to_bits()).collect()
    }
}

impl<'a> Shaper<'a> {
    /// That of a document whose parts have these pieces.
    pub fn new<'p>(
        accessors: &'a Accessors<'a>,
        skins: &'a Skins,
        movers: &'a Movers,
        times: Times,
        parts: impl Iterator<Item = &'p [Piece<'p>]>,
    ) -> Self {
        let mut shaper = Self { accessors, skins, movers, times, numbers: 0, steps: None, kept: 0 };
        let changing = parts.filter(|pieces| pieces.iter().any(|piece| shaper.changes(piece)));
        shaper.numbers = changing.map(|pieces| shaper.followed(pieces).numbers()).fold(0, usize::saturating_add);
        shaper.steps = times.fitting(shaper.numbers);
        shaper
    }

    /// What is said where there are fewer shapes than are asked for.
    pub fn note(&self) -> Option<String> {
        let asked = Some(self.times.rate).filter(|rate| *rate > 0.0 && self.numbers > 0)?;
        let Some((rate, _)) = self.steps else {
            return Some("what bends stays as it is at rest: it has too many joints or morph targets".into());
        };
        let note = || {
            format!(
                "what bends has {rate:.3} shapes a second: {asked} are too many for so long an animation and so many joints"
            )
        };
        (rate < asked).then(note)
    }

    /// Whether joints or weights change a primitive's shape.
    pub fn changes(&self, piece: &Piece) -> bool {
        piece.bends || self.movers.weights(piece.worn.node).is_some()
    }

    /// What pieces follow; nodes whose weights change and poses count once.
    fn followed<'p>(&self, pieces: &'p [Piece<'p>]) -> Followed<'p> {
        let mut followed = Followed::default();
        let (mut of_poses, mut of_nodes) = (FxHashMap::default(), FxHashMap::default());
        for Piece { worn, pose, .. } in pieces {
            let joints = pose.as_deref().map(|pose| -> Range<usize> {
                let known = of_poses.entry(std::ptr::from_ref(pose));
                let new = || {
                    followed.poses.push(pose);
                    appended(&mut followed.joints, pose.joints().len())
                };
                known.or_insert_with(new).clone()
            });
            let mut new = |count: usize| {
                if count > 0 {
                    followed.weighted.push((worn, count));
                }
                appended(&mut followed.weights, count)
            };
            let weights: Range<usize> = match self.movers.weights(worn.node) {
                Some(tracks) => of_nodes.entry(worn.node).or_insert_with(|| new(tracks.len())).clone(),
                None => new(worn.weights.len().min(worn.primitive.targets.len())),
            };
            followed.of_pieces.push((joints, weights));
        }
        followed
    }

    /// How a part changes its shape, which is made of pieces, with `shape` between its node and its own space; `None` where it does not. `offset` is
    /// taken off its positions.
    pub fn changing(
        &mut self,
        part: usize,
        pieces: &[Piece],
        (shape, offset): (&DMat3, DVec3),
    ) -> Result<Option<ChangingPart>, Fault> {
        let Some((rate, count)) = self.steps.filter(|_| pieces.iter().any(|piece| self.changes(piece))) else {
            return Ok(None);
        };
        let mut followed = self.followed(pieces);
        let mut shaped = Vec::with_capacity(pieces.len());
        for (piece, (joints, weights)) in pieces.iter().zip(std::mem::take(&mut followed.of_pieces)) {
            let part_from_own = DAffine3::from_mat3(*shape) * piece.node_from_own;
            let Unshaped { positions, targets, bound } = self.read(piece.worn.primitive, piece.pose.as_deref())?;
            self.kept += targets.iter().map(|target| target.len() as u64).sum::<u64>();
            self.kept += bound.as_ref().map_or(0, |bound| bound.size() as u64);
            if self.kept > self.accessors.limits.points {
                let limit = self.accessors.limits.points;
                return Err(Fault::limit("vertices of morph targets and of joints", self.kept, limit));
            }
            shaped.push(ShapedPiece { positions, targets, bound: bound.zip(joints), weights, part_from_own });
        }
        let (mut shapes, mut steps) = (Vec::new(), Vec::with_capacity(count));
        let mut known: FxHashMap<u64, Vec<u32>> = FxHashMap::default();
        for step in 0..count {
            let numbers = self.numbers(&followed, Some(step as f64 / rate));
            let key = numbers.key();
            let alike = known.entry(xxhash_rust::xxh3::xxh3_64(bytemuck::cast_slice(&key))).or_default();
            let same = alike.iter().copied().find(|&shape| {
                let shape: &Numbers = &shapes[shape as usize];
                shape.key() == key
            });
            steps.push(same.unwrap_or_else(|| {
                shapes.push(numbers);
                alike.push(shapes.len() as u32 - 1);
                shapes.len() as u32 - 1
            }));
        }
        if shapes.len() == 1 && shapes[0].key() == self.numbers(&followed, None).key() {
            return Ok(None);
        }
        let shapes = Arc::new(Shapes { offset, pieces: shaped, shapes });
        Ok(Some(ChangingPart { part, rate, steps, shapes }))
    }

    fn read(&self, primitive: &Primitive, pose: Option<&Pose>) -> Result<Unshaped, Fault> {
        let packed = packed(primitive, self.accessors)?;
        let source = Source { accessors: self.accessors, packed: packed.as_ref() };
        let mut positions = Vec::new();
        if let Some(&accessor) = primitive.attributes.get("POSITION") {
            source.vectors("POSITION", accessor, &["VEC3"], 0.0, |[x, y, z, _]| positions.push(Vec3::new(x, y, z)))?;
        }
        let targets = morphs::targets(primitive, positions.len(), &source)?;
        let bound = pose.map(|pose| Bound::read(pose, primitive, &source)).transpose()?;
        Ok(Unshaped { positions, targets, bound })
    }

    /// Joints and weights at a time, in seconds, or at rest.
    fn numbers(&self, followed: &Followed, time: Option<f64>) -> Numbers {
        let document = self.accessors.document;
        // Most nodes are above several joints.
        let known: RefCell<FxHashMap<usize, DAffine3>> = RefCell::default();
        let place = |node: usize| {
            *known.borrow_mut().entry(node).or_insert_with(|| {
                let moved = time.and_then(|time| self.movers.pose_at(node, time));
                moved.map_or_else(|| local(&document.nodes[node]), |pose| pose.map())
            })
        };
        let mut numbers =
            Numbers { joints: Vec::with_capacity(followed.joints), weights: Vec::with_capacity(followed.weights) };
        for pose in &followed.poses {
            numbers.joints.extend(self.skins.joints(pose, document, &place));
        }
        for &(worn, count) in &followed.weighted {
            match time.zip(self.movers.weights(worn.node)) {
                Some((time, tracks)) => numbers.weights.extend(tracks.iter().map(|track| track.evenly_at(time)[0])),
                None => {
                    let own = worn.weights.iter().map(|&weight| f64::from(weight));
                    numbers.weights.extend(own.chain(std::iter::repeat(0.0)).take(count));
                }
            }
        }
        numbers
    }
}

impl Followed<'_> {
    /// How many numbers there are at a time.
    fn numbers(&self) -> usize {
        self.joints.saturating_mul(12).saturating_add(self.weights)
    }
}

/// So many places behind `end`, which moves behind them.
fn appended(end: &mut usize, count: usize) -> Range<usize> {
    let start = *end;
    *end = start.saturating_add(count);
    start..*end
}

impl PartShapes for Shapes {
    fn count(&self) -> usize {
        self.shapes.len()
    }

    fn positions(&self, shape: usize) -> Vec<Vec3> {
        let numbers = &self.shapes[shape];
        let mut all = Vec::with_capacity(self.pieces.iter().map(|piece| piece.positions.len()).sum());
        for piece in &self.pieces {
            let mut points: Vec<DVec3> = piece.positions.iter().map(|point| point.as_dvec3()).collect();
            for (target, weight) in piece.targets.iter().zip(&numbers.weights[piece.weights.clone()]) {
                if *weight != 0.0 {
                    target.iter().for_each(|(vertex, offset)| points[*vertex as usize] += *weight * offset.as_dvec3());
                }
            }
            let place = |(vertex, &point): (usize, &DVec3)| {
                let point = match &piece.bound {
                    Some((bound, joints)) => bound.placed(vertex, point, &numbers.joints[joints.clone()]),
                    None => point,
                };
                (raised(piece.part_from_own.transform_point3(point)) - self.offset).as_vec3()
            };
            all.extend(points.iter().enumerate().map(place));
        }
        all
    }
}
