//! A solid compiled for evaluation: its primitives in a flat list, and a tape of the operations between them in postfix order. For
//! a region of space the tape is pruned to the operations that matter there, after Matt Keeter, *Massively parallel rendering of
//! complex closed-form implicit surfaces*, SIGGRAPH 2020.

use super::{
    noise::hash,
    paint::Paint,
    shape::Shape,
    solid::{Node, Placement, Solid},
};
use glam::{Mat3, Vec3};

/// Opcodes of a tape; every other code pushes the distance of the leaf with that index, negated if [`INSIDE_OUT`] is set.
const UNION: u32 = u32::MAX;
const INTERSECT: u32 = u32::MAX - 1;
const NOTHING: u32 = u32::MAX - 2;
const EVERYTHING: u32 = u32::MAX - 3;
/// Capacity of the stack of intermediate results.
const STACK: usize = 48;
/// Flag of a leaf whose complement is the solid.
const INSIDE_OUT: u32 = 1 << 31;

/// A compiled solid.
#[derive(Debug)]
pub struct Program {
    leaves: Vec<Leaf>,
    placed_paints: Vec<PlacedPaint>,
    tape: Vec<u32>,
}

/// A placed primitive.
#[derive(Debug)]
pub struct Leaf {
    shape: Shape,
    placement: Placement,
    turned: bool,
    paint_index: u32,
}

impl Leaf {
    /// Signed distance of a point of the scene.
    #[inline]
    pub fn distance(&self, p: Vec3) -> f32 {
        if self.turned {
            self.shape.distance(self.placement.inverse_point(p)) * self.placement.scale
        } else {
            self.shape.distance(p - self.placement.origin)
        }
    }
}

/// A paint and the coordinates that its pattern lies in.
#[derive(Debug)]
pub struct PlacedPaint {
    pub(super) paint: Paint,
    pub(super) placement: Placement,
    pub(super) seed: u32,
}

/// The surface that a distance belongs to.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// Signed distance.
    pub distance: f32,
    tag: u32,
}

/// The stack of intermediate results.
pub struct Stack([Nearest; STACK]);

impl Default for Stack {
    fn default() -> Self {
        Self([Nearest { distance: f32::MAX, tag: 0 }; STACK])
    }
}

/// Classification of a region of space against the shell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// Outside, with no part of the shell.
    Outside,
    /// Inside, with no part of the shell.
    Inside,
    /// Perhaps some of the shell.
    Mixed,
}

impl Program {
    /// Compiles a solid; parts without paint get `paint`.
    pub fn new(solid: &Solid, paint: &Paint) -> Self {
        let mut program = Self { leaves: Vec::new(), placed_paints: Vec::new(), tape: Vec::new() };
        let paint_index = program.add_paint(paint, Placement::IDENTITY);
        program.compile(solid, Placement::IDENTITY, paint_index, false);
        let depth = depth(&program.tape);
        assert!(depth <= STACK, "a solid nests {depth} deep, at most {STACK} are evaluated");
        program
    }

    /// The tape of the whole solid.
    pub fn tape(&self) -> &[u32] {
        &self.tape
    }

    /// The primitive that a nearest surface belongs to, its paint, and whether the solid is outside of the primitive.
    pub fn surface(&self, nearest: Nearest) -> (&Leaf, &PlacedPaint, bool) {
        let leaf = &self.leaves[(nearest.tag & !INSIDE_OUT) as usize];
        (leaf, &self.placed_paints[leaf.paint_index as usize], nearest.tag & INSIDE_OUT != 0)
    }

    fn add_paint(&mut self, paint: &Paint, placement: Placement) -> u32 {
        let index = self.placed_paints.len() as u32;
        self.placed_paints.push(PlacedPaint { paint: paint.clone(), placement, seed: hash(index) });
        index
    }

    /// Appends a solid to the tape, or with `negate` its complement: negation goes down to the leaves (De Morgan).
    fn compile(&mut self, solid: &Solid, placement: Placement, paint_index: u32, negate: bool) {
        let (union, intersect) = if negate { (INTERSECT, UNION) } else { (UNION, INTERSECT) };
        match &*solid.0 {
            Node::Shape(shape) => {
                self.tape.push(self.leaves.len() as u32 | if negate { INSIDE_OUT } else { 0 });
                let turned = placement.linear != Mat3::IDENTITY || placement.scale != 1.0;
                self.leaves.push(Leaf { shape: shape.clone(), placement, turned, paint_index });
            }
            Node::Union(parts) => {
                let Some((first, rest)) = parts.split_first() else {
                    return self.tape.push(if negate { EVERYTHING } else { NOTHING });
                };
                self.compile(first, placement, paint_index, negate);
                for part in rest {
                    self.compile(part, placement, paint_index, negate);
                    self.tape.push(union);
                }
            }
            Node::Intersection(a, b) => {
                self.compile(a, placement, paint_index, negate);
                self.compile(b, placement, paint_index, negate);
                self.tape.push(intersect);
            }
            Node::Difference(a, b) => {
                // The cut inherits the paint of what it is cut from.
                let (a, paint_index) = match &*a.0 {
                    Node::Painted(paint, inner) => (inner, self.add_paint_unless_same(paint, placement, paint_index)),
                    _ => (a, paint_index),
                };
                self.compile(a, placement, paint_index, negate);
                self.compile(b, placement, paint_index, !negate);
                self.tape.push(intersect);
            }
            Node::Complement(cavity) => self.compile(cavity, placement, paint_index, !negate),
            Node::Placed(inner, solid) => self.compile(solid, placement.after(inner), paint_index, negate),
            Node::Painted(paint, solid) => {
                let paint_index = self.add_paint_unless_same(paint, placement, paint_index);
                self.compile(solid, placement, paint_index, negate);
            }
        }
    }

    fn add_paint_unless_same(&mut self, paint: &Paint, placement: Placement, paint_index: u32) -> u32 {
        let current = &self.placed_paints[paint_index as usize];
        let same = current.paint.is(paint)
            && current.placement.origin == placement.origin
            && current.placement.linear == placement.linear
            && current.placement.scale == placement.scale;
        if same { paint_index } else { self.add_paint(paint, placement) }
    }

    /// Prunes `tape` to what matters within `radius` of `center`, where the shell reaches from `outer` outside the surface to
    /// `inner` inside. The pruned tape overwrites `short`.
    pub fn shorten(
        &self,
        tape: &[u32],
        center: Vec3,
        radius: f32,
        (outer, inner): (f32, f32),
        short: &mut Vec<u32>,
    ) -> Region {
        short.clear();
        let mut stack = [(Region::Outside, 0usize); STACK];
        let mut top = 0;
        for &code in tape {
            match code {
                UNION | INTERSECT => {
                    // `nil` leaves the other operand as it is, `all` swallows it.
                    let (nil, all) = match code {
                        UNION => (Region::Outside, Region::Inside),
                        _ => (Region::Inside, Region::Outside),
                    };
                    top -= 1;
                    let (b, (a, start)) = (stack[top].0, stack[top - 1]);
                    let result = if a == nil {
                        b
                    } else if b == nil {
                        a
                    } else if a == all || b == all {
                        short.truncate(start);
                        all
                    } else {
                        short.push(code);
                        Region::Mixed
                    };
                    stack[top - 1].0 = result;
                }
                _ => {
                    let distance = self.distance(code, center);
                    stack[top] = (Region::Mixed, short.len());
                    if distance > radius + outer {
                        stack[top].0 = Region::Outside;
                    } else if distance < -radius - inner {
                        stack[top].0 = Region::Inside;
                    } else {
                        short.push(code);
                    }
                    top += 1;
                }
            }
        }
        stack[0].0
    }

    /// Evaluates a tape at a point: signed distance, and the surface that it belongs to.
    #[inline]
    pub fn nearest(&self, tape: &[u32], p: Vec3, stack: &mut Stack) -> Nearest {
        let stack = &mut stack.0;
        let mut top = 0;
        for &code in tape {
            match code {
                UNION => {
                    top -= 1;
                    if stack[top].distance < stack[top - 1].distance {
                        stack[top - 1] = stack[top];
                    }
                }
                INTERSECT => {
                    top -= 1;
                    if stack[top].distance > stack[top - 1].distance {
                        stack[top - 1] = stack[top];
                    }
                }
                _ => {
                    stack[top] = Nearest { distance: self.distance(code, p), tag: code };
                    top += 1;
                }
            }
        }
        stack[0]
    }

    /// The distance that a code pushes.
    #[inline]
    fn distance(&self, code: u32, p: Vec3) -> f32 {
        match code {
            NOTHING => f32::MAX,
            EVERYTHING => f32::MIN,
            _ if code & INSIDE_OUT != 0 => -self.leaves[(code & !INSIDE_OUT) as usize].distance(p),
            _ => self.leaves[code as usize].distance(p),
        }
    }
}

fn depth(tape: &[u32]) -> usize {
    let (mut depth, mut deepest) = (0, 0);
    for &code in tape {
        match code {
            UNION | INTERSECT => depth -= 1,
            _ => depth += 1,
        }
        deepest = deepest.max(depth);
    }
    deepest
}
