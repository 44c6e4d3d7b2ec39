//! The window without a window system: the thread that traces, the thread that draws, and a surface of VK_EXT_headless_surface between
//! them, so that frames go through a swapchain; wired as the window wires them.

use ash::{ext, khr};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Weak};
use std::time::{Duration, Instant};
use voxtrace_test_support::{Alone, Need, skip_without};
use voxtrace_viewer::engine::{Backend, Engine, Event};
use voxtrace_viewer::gpu::{DrawError, Drawing, Layer, Next, Panels, Screen, Surface};
use voxtrace_vulkan::{Device, Faults, Options, Vulkan};

/// What the two threads tell.
pub enum Told {
    Engine(Event),
    Drawing(Drawing),
}

/// One at a time, as there is one plan of faults in a process.
pub struct Headless {
    pub screen: Screen,
    pub engine: Engine,
    pub faults: Arc<Faults>,
    /// So many surfaces are refused before one is made again.
    pub refused_surfaces: Arc<AtomicU32>,
    told: Receiver<Told>,
    /// Frames that were shown.
    pub shown: u64,
    /// Whether the next frame is due.
    pub is_due: bool,
    /// How often the device was opened anew.
    pub moves: u64,
    /// What went wrong, and what was said about it.
    pub failures: Vec<String>,
    pub notices: Vec<String>,
    instances: Vec<Arc<Vulkan>>,
    opened: Vec<Weak<Device>>,
    _alone: Alone<()>,
}

impl Headless {
    /// `None` where the machine has no device that can show pictures, or no headless surfaces.
    pub fn open(backend: Backend, size: (u32, u32)) -> Option<Self> {
        let alone = Alone::new(|| ());
        let faults = Faults::lasting();
        let names = vec![khr::surface::NAME, ext::headless_surface::NAME];
        let mut options = Options::for_window(true, names);
        options.faults = Some(Arc::clone(&faults));
        let device = match Device::open(options, Some("0"), None) {
            Ok(device) => device,
            Err(error) => {
                skip_without(Need::Vulkan, &error.to_string());
                return None;
            }
        };
        let surface = Surface::headless(device.vulkan()).unwrap();
        if !surface.suits(&device) {
            skip_without(Need::Vulkan, "the device shows no pictures in headless surfaces");
            return None;
        }
        let (sender, told) = channel();
        let of_engine = sender.clone();
        // Whoever listens may be gone.
        let tell = move |drawing| drop(sender.send(Told::Drawing(drawing)));
        let refused_surfaces = Arc::new(AtomicU32::new(0));
        let refused = Arc::clone(&refused_surfaces);
        let make_surface = move |vulkan: &Arc<Vulkan>| {
            let left = refused.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1));
            match left {
                Ok(_) => Err(DrawError::Unsupported("a surface is refused".into())),
                Err(_) => Surface::headless(vulkan),
            }
        };
        let screen = Screen::new(&device, surface, size, make_surface, || {}, tell).unwrap();
        let tell = move |event| drop(of_engine.send(Told::Engine(event)));
        let engine = Engine::start(Arc::clone(&device), backend, tell);
        let instances = vec![Arc::clone(device.vulkan())];
        let opened = vec![Arc::downgrade(&device)];
        let (shown, is_due, moves, failures, notices) = (0, true, 0, Vec::new(), Vec::new());
        Some(Self {
            screen,
            engine,
            faults,
            refused_surfaces,
            told,
            shown,
            is_due,
            moves,
            failures,
            notices,
            instances,
            opened,
            _alone: alone,
        })
    }

    /// Takes what was told; waits for it for at most `patience`.
    pub fn pump(&mut self, patience: Duration) {
        if let Some(told) = self.wait(patience) {
            self.take_all(told);
        }
    }

    /// Waits for what is told, for at most `patience`.
    pub fn wait(&self, patience: Duration) -> Option<Told> {
        self.told.recv_timeout(patience).ok()
    }

    /// Takes what was told, and all else that is there.
    pub fn take_all(&mut self, told: Told) {
        self.take(told);
        while let Ok(told) = self.told.try_recv() {
            self.take(told);
        }
    }

    fn take(&mut self, told: Told) {
        match told {
            Told::Engine(Event::Picture) => self.is_due = true,
            Told::Engine(Event::Notice(text)) => self.notices.push(text),
            Told::Engine(Event::Failed(error)) => self.failures.push(format!("tracing stopped: {error}")),
            Told::Engine(Event::Stale) => self.failures.push("an edit was not followed".into()),
            Told::Engine(Event::Gone(error)) => panic!("the device is gone: {error}"),
            Told::Engine(Event::Moved(device)) => {
                self.moves += 1;
                self.instances.push(Arc::clone(device.vulkan()));
                self.opened.push(Arc::downgrade(&device));
                self.screen.move_to(&device).unwrap();
            }
            Told::Drawing(drawing) => {
                self.shown += u64::from(matches!(drawing, Drawing::Ready { is_shown: true }));
                match self.screen.take(drawing) {
                    Ok(Next::Nothing) => {}
                    Ok(Next::Draw) => self.is_due = true,
                    Ok(Next::Reopen(device)) => self.engine.lost(device),
                    Err(error) => {
                        self.failures.push(error.to_string());
                        self.is_due = true;
                    }
                }
            }
        }
    }

    /// Draws a frame where one is due and the last one is over.
    pub fn draw(&mut self, layer: Option<Layer>, panels: impl FnOnce() -> Panels) {
        if self.is_due && self.screen.is_ready() {
            self.is_due = false;
            self.screen.draw(layer, panels());
        }
    }

    /// What the validation layer said, on all devices that there were.
    pub fn messages(&self) -> Vec<String> {
        self.instances.iter().flat_map(|vulkan| vulkan.messages().first()).collect()
    }

    /// How many devices there are.
    pub fn devices(&mut self) -> usize {
        self.opened.retain(|device| device.strong_count() > 0);
        self.opened.len()
    }

    /// Lets go of the instances whose devices are gone, so that a long run does not gather them; what they said is kept.
    pub fn forget_instances(&mut self) -> Vec<String> {
        let messages = self.messages();
        let last = self.instances.len() - 1;
        self.instances.drain(..last);
        messages
    }
}

/// Does something until it says that it is done. Panics after five minutes: on a busy machine shaders of software take long to compile.
pub fn until(what: &str, mut done: impl FnMut() -> bool) {
    let start = Instant::now();
    while !done() {
        assert!(start.elapsed() < Duration::from_secs(300), "{what} did not come");
    }
}
