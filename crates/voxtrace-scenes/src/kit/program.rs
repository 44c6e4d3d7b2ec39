//! A solid made ready for evaluation: its primitives in a flat list and the operations between them in postfix order,
//! so that a region of space can be given a shorter tape with only what matters there. The idea is that of Matt
//! Keeter, *Massively parallel rendering of complex closed-form implicit surfaces*, SIGGRAPH 2020.

use super::{
    noise::hash,
    paint::Paint,
    shape::Shape,
    solid::{Node, Placement, Solid},
};
use glam::{Mat3, Vec3};

/// Operations on a tape; every other code is the index of a leaf, perhaps [`INSIDE_OUT`], whose distance it pushes.
const UNION: u32 = u32::MAX;
const INTERSECT: u32 = u32::MAX - 1;
const NOTHING: u32 = u32::MAX - 2;
const EVERYTHING: u32 = u32::MAX - 3;
/// Most intermediate results at a time.
const STACK: usize = 48;
/// Marks a leaf of which the outside is the solid.
const INSIDE_OUT: u32 = 1 << 31;

/// A solid, flat.
#[derive(Debug)]
pub struct Program {
    leaves: Vec<Leaf>,
    coats: Vec<Coat>,
    tape: Vec<u32>,
}

/// A placed primitive.
#[derive(Debug)]
pub struct Leaf {
    shape: Shape,
    placement: Placement,
    turned: bool,
    coat: u32,
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
pub struct Coat {
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

/// Room for intermediate results.
pub struct Stack([Nearest; STACK]);

impl Default for Stack {
    fn default() -> Self {
        Self([Nearest { distance: f32::MAX, tag: 0 }; STACK])
    }
}

/// What a region of space is, as far as the shell goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// No part of the shell: beyond the margin outside.
    Outside,
    /// No part of the shell: beyond the margin inside.
    Inside,
    /// Perhaps some of the shell.
    Mixed,
}

impl Program {
    /// Compiles a solid; parts without paint get `paint`.
    pub fn new(solid: &Solid, paint: &Paint) -> Self {
        let mut program = Self { leaves: Vec::new(), coats: Vec::new(), tape: Vec::new() };
        let coat = program.coat(paint, Placement::IDENTITY);
        program.compile(solid, Placement::IDENTITY, coat, false);
        let depth = depth(&program.tape);
        assert!(depth <= STACK, "a solid nests {depth} deep, at most {STACK} are evaluated");
        program
    }

    /// The tape of the whole solid.
    pub fn tape(&self) -> &[u32] {
        &self.tape
    }

    /// The primitive that a nearest surface belongs to, its coat, and whether the solid is outside of the primitive.
    pub fn surface(&self, nearest: Nearest) -> (&Leaf, &Coat, bool) {
        let leaf = &self.leaves[(nearest.tag & !INSIDE_OUT) as usize];
        (leaf, &self.coats[leaf.coat as usize], nearest.tag & INSIDE_OUT != 0)
    }

    fn coat(&mut self, paint: &Paint, placement: Placement) -> u32 {
        let index = self.coats.len() as u32;
        self.coats.push(Coat { paint: paint.clone(), placement, seed: hash(index) });
        index
    }

    /// Appends a solid to the tape, or with `negate` its complement: negation goes down to the leaves (De Morgan).
    fn compile(&mut self, solid: &Solid, placement: Placement, coat: u32, negate: bool) {
        let (union, intersect) = if negate { (INTERSECT, UNION) } else { (UNION, INTERSECT) };
        match &*solid.0 {
            Node::Shape(shape) => {
                self.tape.push(self.leaves.len() as u32 | if negate { INSIDE_OUT } else { 0 });
                let turned = placement.linear != Mat3::IDENTITY || placement.scale != 1.0;
                self.leaves.push(Leaf { shape: shape.clone(), placement, turned, coat });
            }
            Node::Union(parts) => {
                let Some((first, rest)) = parts.split_first() else {
                    return self.tape.push(if negate { EVERYTHING } else { NOTHING });
                };
                self.compile(first, placement, coat, negate);
                for part in rest {
                    self.compile(part, placement, coat, negate);
                    self.tape.push(union);
                }
            }
            Node::Intersection(a, b) => {
                self.compile(a, placement, coat, negate);
                self.compile(b, placement, coat, negate);
                self.tape.push(intersect);
            }
            Node::Difference(a, b) => {
                // The cut inherits the paint of what it is cut from.
                let (a, coat) = match &*a.0 {
                    Node::Painted(paint, inner) => (inner, self.coat_unless_same(paint, placement, coat)),
                    _ => (a, coat),
                };
                self.compile(a, placement, coat, negate);
                self.compile(b, placement, coat, !negate);
                self.tape.push(intersect);
            }
            Node::Complement(cavity) => self.compile(cavity, placement, coat, !negate),
            Node::Placed(inner, solid) => self.compile(solid, placement.after(inner), coat, negate),
            Node::Painted(paint, solid) => {
                let coat = self.coat_unless_same(paint, placement, coat);
                self.compile(solid, placement, coat, negate);
            }
        }
    }

    fn coat_unless_same(&mut self, paint: &Paint, placement: Placement, coat: u32) -> u32 {
        let current = &self.coats[coat as usize];
        let same = current.paint.is(paint)
            && current.placement.origin == placement.origin
            && current.placement.linear == placement.linear
            && current.placement.scale == placement.scale;
        if same { coat } else { self.coat(paint, placement) }
    }

    /// Shortens `tape` to what matters within `radius` of `center`, where the shell lies from `outer` outside of the
    /// surface to `inner` inside. `short` is overwritten.
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

    /// Signed distance of a point by a tape, and the surface that it belongs to.
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
