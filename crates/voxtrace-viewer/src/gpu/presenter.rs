//! The thread that draws the window. Drivers let their callers wait, for an image, for a frame, for the other queue, and those in
//! software draw while they are called: the thread that takes events hands frames over and goes on.

use super::layer::{Layer, Panels};
use super::swapchain::{Outcome, Surface, Window};
use super::textures::Textures;
use super::{DrawError, Loss};
use crate::phases::Phases;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::Duration;
use voxtrace_vulkan::Device;

/// What fails is tried again after this time.
const BETWEEN_TRIES: Duration = Duration::from_millis(100);

/// What the thread tells.
pub enum Drawing {
    /// The next frame can come; where it is not `is_shown`, it should: the window changed meanwhile.
    Ready {
        /// Whether the last one is shown, or will be when the window is.
        is_shown: bool,
    },
    /// The device or the surface is gone. Frames are left out until the presenter moves to another.
    Lost(Loss, Arc<Device>),
    /// A frame failed otherwise; the next one may do.
    Failed(DrawError),
}

/// An order.
enum Order {
    Frame(Box<(Option<Layer>, Panels)>),
    Size((u32, u32)),
    Move(Arc<Device>, Arc<Surface>),
    Quit,
}

/// What both threads see.
#[derive(Default)]
struct Shared {
    /// Whether a frame waits or is being drawn.
    is_busy: AtomicBool,
    phases: Mutex<Phases>,
}

/// The drawing thread of a window.
pub struct Presenter {
    orders: Sender<Order>,
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

impl Presenter {
    /// Starts the thread, which draws into a surface of `size` pixels. On the thread, `about_to_show` is called before each frame
    /// that is shown, and `tell` after each frame.
    ///
    /// # Errors
    /// [`DrawError::Unsupported`] where the device cannot; what the driver answers.
    pub fn start(
        device: &Arc<Device>,
        surface: &Arc<Surface>,
        size: (u32, u32),
        about_to_show: impl Fn() + Send + 'static,
        tell: impl Fn(Drawing) + Send + 'static,
    ) -> Result<Self, DrawError> {
        let window = Window::new(device, surface, size)?;
        let (orders, receiver) = channel();
        let shared = Arc::new(Shared::default());
        let mut worker = Worker {
            orders: receiver,
            shared: Arc::clone(&shared),
            about_to_show: Box::new(about_to_show),
            tell: Box::new(tell),
            window: Some(window),
            device: Arc::clone(device),
            surface: Some(Arc::clone(surface)),
            size,
            textures: Textures::default(),
        };
        let thread = std::thread::Builder::new().name("window".into()).spawn(move || worker.run());
        let thread = thread.map_err(|error| DrawError::Unsupported(format!("no thread can be started: {error}")))?;
        Ok(Self { orders, shared, thread: Some(thread) })
    }

    /// Whether the last frame is not drawn yet. [`Drawing::Ready`] says when it is.
    pub fn is_busy(&self) -> bool {
        self.shared.is_busy.load(Ordering::Acquire)
    }

    /// Hands a frame over.
    pub fn draw(&self, layer: Option<Layer>, panels: Panels) {
        self.shared.is_busy.store(true, Ordering::Release);
        self.send(Order::Frame(Box::new((layer, panels))));
    }

    /// The window has another size, pixels.
    pub fn resize(&self, size: (u32, u32)) {
        self.send(Order::Size(size));
    }

    /// Draws on with another device, into another surface of the window.
    pub fn move_to(&self, device: &Arc<Device>, surface: &Arc<Surface>) {
        self.send(Order::Move(Arc::clone(device), Arc::clone(surface)));
    }

    /// What frames were spent on.
    pub fn phases(&self) -> Phases {
        locked(&self.shared.phases).clone()
    }

    fn send(&self, order: Order) {
        // The thread is there until this value is dropped, or it panicked, which was printed.
        let _ = self.orders.send(order);
    }
}

impl Drop for Presenter {
    fn drop(&mut self) {
        self.send(Order::Quit);
        if let Some(thread) = self.thread.take() {
            // A panic was printed when it happened.
            let _ = thread.join();
        }
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The state of the thread.
struct Worker {
    orders: Receiver<Order>,
    shared: Arc<Shared>,
    about_to_show: Box<dyn Fn() + Send>,
    tell: Box<dyn Fn(Drawing) + Send>,
    /// `None` after an error.
    window: Option<Window>,
    device: Arc<Device>,
    /// `None` while it or the device is gone.
    surface: Option<Arc<Surface>>,
    size: (u32, u32),
    textures: Textures,
}

impl Worker {
    fn run(&mut self) {
        while let Ok(order) = self.orders.recv() {
            match order {
                Order::Quit => return,
                Order::Size(size) => {
                    self.size = size;
                    if let Some(window) = &mut self.window {
                        window.resize(size);
                    }
                }
                Order::Move(device, surface) => {
                    // The old ones first: a window has one swapchain at a time.
                    (self.window, self.surface) = (None, Some(surface));
                    self.device = device;
                    self.open();
                }
                Order::Frame(frame) => {
                    let (layer, panels) = *frame;
                    self.draw(layer, panels);
                }
            }
        }
    }

    fn draw(&mut self, layer: Option<Layer>, panels: Panels) {
        self.textures.take(&panels.textures);
        if self.window.is_none() {
            self.open();
        }
        // A picture may lie on a device that is gone.
        let layer = layer.filter(|layer| Arc::ptr_eq(layer.picture.device(), &self.device));
        let mut phases = locked(&self.shared.phases).clone();
        phases.begin();
        let result = match &mut self.window {
            Some(window) => window.draw(layer.as_ref(), panels, &self.about_to_show, &mut phases),
            None => Ok(Outcome::Hidden),
        };
        phases.end("rest");
        *locked(&self.shared.phases) = phases;
        // A picture that another has replaced goes with its last frame.
        drop(layer);
        if self.surface.is_none() {
            // Who has none to give tries again after this frame.
            std::thread::sleep(BETWEEN_TRIES);
        }
        self.shared.is_busy.store(false, Ordering::Release);
        match result {
            Ok(outcome) => (self.tell)(Drawing::Ready { is_shown: outcome != Outcome::Again }),
            Err(error) => self.fail(error),
        }
    }

    /// Makes the window's images and what draws them, with the textures that the panels have.
    fn open(&mut self) {
        let Some(surface) = &self.surface else { return };
        let made = Window::new(&self.device, surface, self.size).and_then(|mut window| {
            window.take_textures(self.textures.all())?;
            Ok(window)
        });
        match made {
            Ok(window) => {
                self.window = Some(window);
                (self.tell)(Drawing::Ready { is_shown: false });
            }
            Err(error) => self.fail(error),
        }
    }

    /// Takes down what failed, so that it is made anew: by the next frame, or, where more than that is gone, by who is told.
    fn fail(&mut self, error: DrawError) {
        self.window = None;
        std::thread::sleep(BETWEEN_TRIES);
        match error.loss() {
            Some(loss) => {
                self.surface = None;
                (self.tell)(Drawing::Lost(loss, Arc::clone(&self.device)));
            }
            None => (self.tell)(Drawing::Failed(error)),
        }
    }
}
