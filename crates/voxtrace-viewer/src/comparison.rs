//! Two tracers on the same view: the second one's settings, what is shown of both, and where the divider stands.

use crate::engine::{Backend, Contrast};
use crate::session::{Command, Session};
use voxtrace::glam::Vec2;
use voxtrace_vulkan::{Primitive, Settings, Traversal};

/// How far a key moves the divider, as a share of the picture.
pub const DIVIDER_STEP: f32 = 0.02;

/// Pixels beside the divider that still take it.
const GRIP: f32 = 8.0;

/// What the picture is compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// How the second tracer's rays find voxels.
    pub traversal: Traversal,
    /// What ray tracing hardware sees of it.
    pub primitive: Primitive,
    /// Whether the driver may round as it likes.
    pub fast: bool,
    /// What is shown of both.
    pub contrast: Contrast,
    /// Where the divider stands, as a share of the picture's width.
    pub split: f32,
}

impl Comparison {
    /// The second tracer.
    pub fn backend(&self) -> Backend {
        backend(self.traversal, self.primitive, self.fast)
    }
}

/// What traces with these settings.
pub fn backend(traversal: Traversal, primitive: Primitive, fast: bool) -> Backend {
    match traversal {
        Traversal::Cpu => Backend::Cpu,
        traversal => Backend::Device(Settings { traversal, primitive, is_exact: !fast }),
    }
}

/// What a tracer is called, as short as can be.
pub fn tracer_name(backend: Backend) -> String {
    match backend {
        Backend::Cpu => Traversal::Cpu.name().into(),
        Backend::Device(settings) => {
            let primitive = settings.traversal.uses_primitives().then(|| settings.primitive.name());
            let words = [Some(settings.traversal.name()), primitive, (!settings.is_exact).then_some("fast")];
            words.into_iter().flatten().collect::<Vec<_>>().join(" ")
        }
    }
}

impl Session {
    /// Compares with another tracer, or no more. The last settings of a comparison are taken again.
    pub fn toggle_comparison(&mut self) {
        let next = match &self.comparison {
            Some(_) => None,
            None => Some(self.last_comparison.clone().unwrap_or_else(|| self.usual_comparison())),
        };
        self.set_comparison(next);
    }

    /// The next traversal of the machine beside the picture's own.
    fn usual_comparison(&self) -> Comparison {
        Comparison {
            traversal: self.traversal_after(self.render_settings.traversal),
            primitive: Primitive::default(),
            fast: false,
            contrast: Contrast::default(),
            split: 0.5,
        }
    }

    fn traversal_after(&self, traversal: Traversal) -> Traversal {
        let all = &self.traversals;
        let here = all.iter().position(|&other| other == traversal).unwrap_or(0);
        all[(here + 1) % all.len()]
    }

    /// Takes another comparison, or none.
    pub fn set_comparison(&mut self, comparison: Option<Comparison>) {
        let comparison =
            comparison.map(|comparison| Comparison { split: comparison.split.clamp(0.0, 1.0), ..comparison });
        let old = std::mem::replace(&mut self.comparison, comparison);
        let new = &self.comparison;
        let by = |comparison: &Option<Comparison>| comparison.as_ref().map(Comparison::backend);
        let what = |comparison: &Option<Comparison>| comparison.as_ref().map(|comparison| comparison.contrast);
        let (other, contrast) = (by(new), what(new));
        if other != by(&old) {
            self.ask(Command::CompareWith(other));
        }
        if let Some(contrast) = contrast.filter(|_| contrast != what(&old)) {
            self.ask(Command::SetContrast(contrast));
        }
        if old.is_some() {
            self.last_comparison = old;
        }
    }

    /// Asks an engine that is new for the comparison; none is left where the device cannot trace so.
    pub fn ask_for_comparison(&mut self) {
        let comparison = self.comparison.take();
        self.set_comparison(comparison.filter(|comparison| self.traversals.contains(&comparison.traversal)));
    }

    /// Moves the divider by a share of the picture's width.
    pub fn move_divider(&mut self, by: f32) {
        if let Some(comparison) = &mut self.comparison {
            comparison.split = (comparison.split + by).clamp(0.0, 1.0);
        }
    }

    /// Whether the divider is shown, and a place in the picture is on it.
    pub fn is_on_divider(&self, place: Vec2) -> bool {
        let at = self.comparison.as_ref().filter(|comparison| comparison.contrast == Contrast::Beside);
        let at = at.filter(|_| self.open.is_some()).map(|comparison| comparison.split * self.size().0 as f32);
        at.is_some_and(|at| (place.x - at).abs() <= GRIP)
    }

    /// The next of the second tracer's traversals; begins to compare where nothing is compared.
    pub fn next_other_traversal(&mut self) {
        let Some(now) = self.comparison.clone() else { return self.toggle_comparison() };
        let traversal = self.traversal_after(now.traversal);
        self.set_comparison(Some(Comparison { traversal, ..now }));
    }

    /// The next of what is shown of two tracers; begins to compare where nothing is compared.
    pub fn next_contrast(&mut self) {
        let Some(now) = self.comparison.clone() else { return self.toggle_comparison() };
        let here = Contrast::ALL.iter().position(|&contrast| contrast == now.contrast).unwrap_or(0);
        let contrast = Contrast::ALL[(here + 1) % Contrast::ALL.len()];
        self.set_comparison(Some(Comparison { contrast, ..now }));
        self.say(contrast.name(), false);
    }
}
