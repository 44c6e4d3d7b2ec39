//! Tracing for one client, on a thread of its own: a picture of each view soon, as fine as there is time for, and where the view stands, all its samples.
//! Nothing is traced while the client has pictures that it has not shown, and nothing once it is gone.

use super::messages::{Head, Packing, View, packed};
use crate::picture::Shown;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use voxtrace::{Film, Frame, PackedScene, Progress, TraceError, Tracer};

/// Pictures that a client may have before it shows them: one that becomes colours, one that becomes a file, one that travels.
const MOST_UNSHOWN: u32 = 3;
/// What tracing a picture of a view that moves may take, and what each step after it may.
const MOVING: Duration = Duration::from_millis(30);
/// What is traced of a view that stands before it is shown again.
const STANDING: Duration = Duration::from_millis(500);
/// A view stands when no other came for so long.
const SETTLED: Duration = Duration::from_millis(200);
/// Most samples of a picture of a view that moves, and how much smaller than asked for it may be.
const MOST_MOVING_SAMPLES: u32 = 8;
const COARSEST: f64 = 10.0;
/// Steps between sizes of such pictures, and how much too large one may be before the next smaller comes.
const STEP: f64 = 1.2;
const OVER: f64 = 1.05;
/// Quality of pictures of views that move, and of those that gather light.
const MOVING_QUALITY: u8 = 78;
const STANDING_QUALITY: u8 = 90;

/// What the client wants, as far as it is known.
#[derive(Default)]
struct Wants {
    view: Option<(View, Instant)>,
    /// Pictures that it has not shown yet.
    unshown: u32,
    is_over: bool,
    /// The render that is going on, and whether another view cancels it.
    render: Option<(Arc<Progress>, Work)>,
}

/// What is rendered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Work {
    /// A quick picture, which is finished even where the view has moved on: else a view that moves all the time would never be seen.
    Quick,
    /// Samples of a view that stands.
    Standing,
}

/// The client as the thread that traces sees it.
#[derive(Default)]
pub struct Client {
    wants: Mutex<Wants>,
    changed: Condvar,
}

impl Client {
    fn lock(&self) -> MutexGuard<'_, Wants> {
        self.wants.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, change: impl FnOnce(&mut Wants)) {
        change(&mut self.lock());
        self.changed.notify_all();
    }

    /// Wants another view; what is traced of the one before ends.
    pub fn show(&self, view: View) {
        self.change(|wants| {
            if wants.view.as_ref().is_some_and(|(before, _)| *before == view) {
                return;
            }
            wants.view = Some((view, Instant::now()));
            if let Some((progress, Work::Standing)) = &wants.render {
                progress.cancel();
            }
        });
    }

    /// Has shown a picture.
    pub fn acknowledge(&self) {
        self.change(|wants| wants.unshown = wants.unshown.saturating_sub(1));
    }

    /// Wants nothing any more.
    pub fn leave(&self) {
        self.change(|wants| {
            wants.is_over = true;
            if let Some((progress, _)) = &wants.render {
                progress.cancel();
            }
        });
    }
}

/// Why tracing for a client ends by itself.
#[derive(Debug, thiserror::Error)]
pub enum SessionError {
    #[error(transparent)]
    Trace(#[from] TraceError),
    #[error("a picture cannot be packed: {0}")]
    Packing(#[from] std::io::Error),
}

/// A tracer that works for a client.
pub struct Session<'a> {
    pub scene: &'a PackedScene,
    pub tracer: &'a mut dyn Tracer,
    pub client: &'a Client,
    /// Of each pixel, where the client says nothing about it.
    pub samples: u32,
    /// Takes messages with pictures; whether the client is still there.
    pub send: &'a mut (dyn FnMut(Vec<u8>) -> bool + Send),
}

/// Pixels on their way to become a message: a film, or what a screen shows of it.
struct Passed<T> {
    head: Head,
    pixels: T,
    packing: Packing,
}

/// How far the pictures of a view are.
struct Standing {
    view: View,
    frame: Frame,
    /// Samples of each pixel of the film; 0 before it has begun.
    samples: u32,
}

/// What to do next.
enum Step {
    /// A quick picture of another view.
    Move(View),
    /// More samples of the view that stands.
    Gather,
    Leave,
}

/// How long a stage took for a pixel of the last picture, nanoseconds; 0 before there was one.
#[derive(Default)]
struct Pace(AtomicU64);

impl Pace {
    fn set(&self, time: Duration, width: u32, height: u32) {
        let pixels = (f64::from(width) * f64::from(height)).max(1.0);
        self.0.store((time.as_secs_f64() * 1e9 / pixels).ceil() as u64, Ordering::Relaxed);
    }

    /// Most pixels that it takes for a picture of a view that moves.
    fn most_pixels(&self) -> f64 {
        MOVING.as_secs_f64() * 1e9 / self.0.load(Ordering::Relaxed).max(1) as f64
    }
}

impl Session<'_> {
    /// Works until the client has left. While a picture is traced, the one before it becomes colours, and the one before that a file.
    pub fn run(self) -> Result<(), SessionError> {
        let Self { scene, tracer, client, samples, send } = self;
        let (developing, packing) = (Pace::default(), Pace::default());
        std::thread::scope(|scope| {
            let (films, traced) = sync_channel(1);
            let (pictures, developed) = sync_channel(1);
            let (spares, spare) = sync_channel(2);
            scope.spawn(|| develop(traced, pictures, spares, &developing));
            let packer = scope.spawn(|| pack(developed, &packing, send));
            let mut tracing = Tracing { scene, tracer, client, samples, films, spare, paces: [&developing, &packing] };
            let done = tracing.run();
            drop(tracing);
            done.and(packer.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
        })
    }
}

/// Makes what a screen shows of films, until there are no more or nobody takes it. Films go back as spare ones: memory that nobody has had yet takes
/// the system longer to give than a picture to be read.
fn develop(films: Receiver<Passed<Film>>, pictures: SyncSender<Passed<Shown>>, spares: SyncSender<Film>, pace: &Pace) {
    for Passed { head, pixels: film, packing } in films {
        let start = Instant::now();
        let pixels = Shown::new(film.width, film.height, |index| film.pixels[index].mean());
        pace.set(start.elapsed(), film.width, film.height);
        // There are enough of them, or nobody traces any more.
        let _ = spares.try_send(film);
        if pictures.send(Passed { head, pixels, packing }).is_err() {
            break;
        }
    }
}

/// Makes messages of pictures and sends them, until there are no more or the client is gone.
fn pack(
    pictures: Receiver<Passed<Shown>>,
    pace: &Pace,
    send: &mut (dyn FnMut(Vec<u8>) -> bool + Send),
) -> Result<(), SessionError> {
    for Passed { head, pixels: shown, packing } in pictures {
        let start = Instant::now();
        let message = packed(head, &shown, packing)?;
        if packing != Packing::Lossless {
            pace.set(start.elapsed(), shown.width, shown.height);
        }
        if !send(message) {
            break;
        }
    }
    Ok(())
}

/// The part of a session that traces.
struct Tracing<'a> {
    scene: &'a PackedScene,
    tracer: &'a mut dyn Tracer,
    client: &'a Client,
    samples: u32,
    films: SyncSender<Passed<Film>>,
    /// Films that nobody needs any more.
    spare: Receiver<Film>,
    /// Of what follows.
    paces: [&'a Pace; 2],
}

impl Tracing<'_> {
    fn run(&mut self) -> Result<(), SessionError> {
        let (mut standing, mut sent, mut speed) = (None, 0, Speed::default());
        loop {
            match self.next(standing.as_ref()) {
                Step::Leave => return Ok(()),
                Step::Move(view) => {
                    let frame = view.frame(self.scene, self.samples)?;
                    let most = self.paces.map(Pace::most_pixels);
                    let quick = speed.quick(&frame, most[0].min(most[1]));
                    if !self.trace(&quick, Work::Quick, &view, &mut speed)? {
                        continue;
                    }
                    sent += 1;
                    let head = Head { frame: sent, view: view.id, samples: quick.samples, of: frame.samples };
                    if !self.send(head, &quick, Packing::Lossy(MOVING_QUALITY))? {
                        return Ok(());
                    }
                    standing = Some(Standing { view, frame, samples: 0 });
                }
                Step::Gather => {
                    let Some(standing) = standing.as_mut() else { continue };
                    let samples = speed.more(&standing.frame, standing.samples);
                    let part = standing.frame.clone().samples(samples);
                    if !self.trace(&part, Work::Standing, &standing.view, &mut speed)? {
                        continue;
                    }
                    standing.samples = samples;
                    let is_whole = samples == standing.frame.samples;
                    sent += 1;
                    let head = Head { frame: sent, view: standing.view.id, samples, of: standing.frame.samples };
                    let packing = if is_whole { Packing::Lossless } else { Packing::Lossy(STANDING_QUALITY) };
                    if !self.send(head, &part, packing)? {
                        return Ok(());
                    }
                }
            }
        }
    }

    /// Waits until there is something to do, and room for a picture at the client.
    fn next(&self, standing: Option<&Standing>) -> Step {
        let mut wants = self.client.lock();
        loop {
            if wants.is_over {
                return Step::Leave;
            }
            let mut wait = None;
            if wants.unshown < MOST_UNSHOWN
                && let Some((view, since)) = &wants.view
            {
                match standing.filter(|standing| standing.view == *view) {
                    None => return Step::Move(view.clone()),
                    Some(standing) if standing.samples < standing.frame.samples => {
                        match SETTLED.checked_sub(since.elapsed()) {
                            None => return Step::Gather,
                            left => wait = left,
                        }
                    }
                    Some(_) => {}
                }
            }
            let changed = &self.client.changed;
            wants = match wait {
                Some(wait) => changed.wait_timeout(wants, wait).unwrap_or_else(PoisonError::into_inner).0,
                None => changed.wait(wants).unwrap_or_else(PoisonError::into_inner),
            };
        }
    }

    /// Renders a frame, unless the client wants something else meanwhile; whether it is whole.
    fn trace(&mut self, frame: &Frame, work: Work, view: &View, speed: &mut Speed) -> Result<bool, TraceError> {
        let progress = Arc::new(Progress::default());
        {
            let mut wants = self.client.lock();
            let is_old = wants.view.as_ref().is_none_or(|(wanted, _)| wanted != view);
            if wants.is_over || work == Work::Standing && is_old {
                return Ok(false);
            }
            wants.render = Some((Arc::clone(&progress), work));
        }
        let start = Instant::now();
        let rendered = self.tracer.render(frame, &progress);
        self.client.lock().render = None;
        rendered?;
        speed.learn(progress.samples_done(), start.elapsed());
        Ok(!progress.is_cancelled())
    }

    /// Hands the tracer's film on; whether the client is still there.
    fn send(&mut self, head: Head, frame: &Frame, packing: Packing) -> Result<bool, SessionError> {
        let anew = |_| Film::new(frame.width, frame.height, frame.region, frame.first_sample);
        let mut film = self.spare.try_recv().unwrap_or_else(anew);
        self.tracer.read(&mut film)?;
        self.client.lock().unshown += 1;
        Ok(self.films.send(Passed { head, pixels: film, packing }).is_ok())
    }
}

/// How fast the tracer is, as measured, and how fine pictures are for that.
struct Speed {
    /// Samples of pixels in a second.
    samples: f64,
    /// How much smaller than asked for the last picture of a view that moves was.
    scale: f64,
}

impl Default for Speed {
    fn default() -> Self {
        Self { samples: 1e6, scale: COARSEST }
    }
}

impl Speed {
    fn learn(&mut self, samples: u64, time: Duration) {
        // Of short renders most is not tracing.
        if samples > 1000 {
            let seen = samples as f64 / time.as_secs_f64().max(1e-4);
            self.samples = 0.5 * self.samples + 0.5 * seen;
        }
    }

    /// The frame as fine as there is time for while the view moves, and of at most so many pixels. Sizes are steps that stay: films of another size are
    /// made anew, and a picture whose size wavers is not quiet.
    fn quick(&mut self, frame: &Frame, most_pixels: f64) -> Frame {
        let pixels = f64::from(frame.width) * f64::from(frame.height);
        let most = self.samples * MOVING.as_secs_f64();
        let scale = (pixels / most.min(most_pixels)).sqrt().clamp(1.0, COARSEST);
        if scale > self.scale * OVER || scale < self.scale / STEP / OVER {
            self.scale = STEP.powf(scale.log(STEP).ceil()).min(COARSEST);
        }
        let length = |length: u32| ((f64::from(length) / self.scale).round() as u32).max(1);
        let samples = ((most / pixels) as u32).clamp(1, MOST_MOVING_SAMPLES.min(frame.samples));
        frame.clone().size(length(frame.width), length(frame.height)).samples(samples)
    }

    /// Samples that the film of a view that stands has next: at most twice as many.
    fn more(&self, frame: &Frame, samples: u32) -> u32 {
        let pixels = f64::from(frame.width) * f64::from(frame.height);
        let more = (self.samples * STANDING.as_secs_f64() / pixels) as u32;
        (samples + more.clamp(1, samples.max(1))).min(frame.samples)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::mpsc::channel;
    use voxtrace::CpuTracer;

    fn view(id: u32, samples: u32) -> View {
        let camera = [20.0, -60.0, 30.0, 10.0, 10.0, 5.0, 0.0, 0.0, 1.0, 45.0];
        View { id, camera, width: 96, height: 64, samples: Some(samples) }
    }

    fn head(message: &[u8]) -> (Head, u32) {
        let number = |at: usize| u32::from_le_bytes(message[at * 4..at * 4 + 4].try_into().unwrap());
        (Head { frame: number(0), view: number(1), samples: number(2), of: number(3) }, number(4))
    }

    /// Runs a session while `client_does` is done with its pictures.
    fn with_session(client_does: impl FnOnce(&Client, &Receiver<Vec<u8>>)) {
        let scene = Arc::new(PackedScene::pack(&voxtrace::scenes::generate("city", Some(20_000)).unwrap()).unwrap());
        let (client, (sender, pictures)) = (Client::default(), channel());
        std::thread::scope(|scope| {
            let (of_session, scene) = (&client, &scene);
            let session = scope.spawn(move || {
                let mut tracer = CpuTracer::new(None);
                tracer.set_scene(scene).unwrap();
                let mut send = |message| sender.send(message).is_ok();
                Session { scene, tracer: &mut tracer, client: of_session, samples: 4, send: &mut send }.run()
            });
            client_does(&client, &pictures);
            client.leave();
            session.join().unwrap().unwrap();
        });
    }

    #[test]
    fn a_view_is_shown_soon_and_without_loss_when_it_has_all_samples() {
        with_session(|client, pictures| {
            client.show(view(7, 4));
            let mut last = 0;
            loop {
                let message = pictures.recv().unwrap();
                client.acknowledge();
                let (head, kind) = head(&message);
                assert_eq!((head.view, head.of), (7, 4));
                assert!(head.frame == last + 1 && head.samples <= 4);
                last = head.frame;
                if kind == 0 {
                    assert_eq!(message[20..22], [0xFF, 0xD8], "a JPEG");
                    continue;
                }
                assert!(message[20..].starts_with(b"\x89PNG") && head.samples == 4);
                let mut reader = png::Decoder::new(std::io::Cursor::new(&message[20..])).read_info().unwrap();
                let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
                reader.next_frame(&mut pixels).unwrap();
                // Those of the same picture, rendered here.
                let scene =
                    Arc::new(PackedScene::pack(&voxtrace::scenes::generate("city", Some(20_000)).unwrap()).unwrap());
                let frame = view(7, 4).frame(&scene, 1).unwrap();
                let mut tracer = CpuTracer::new(None);
                tracer.set_scene(&scene).unwrap();
                tracer.render(&frame, &Progress::default()).unwrap();
                let mut film = Film::new(96, 64, frame.region, 0);
                tracer.read(&mut film).unwrap();
                assert!(pixels == Shown::new(96, 64, |index| film.pixels[index].mean()).samples);
                film.pixels[40].add(voxtrace::glam::Vec3::splat(9.0), true);
                assert!(pixels != Shown::new(96, 64, |index| film.pixels[index].mean()).samples);
                break;
            }
            assert!(pictures.recv_timeout(2 * SETTLED).is_err(), "a picture that is whole is not sent again");
        });
    }

    #[test]
    fn a_client_that_shows_nothing_gets_three_pictures_however_much_it_moves() {
        with_session(|client, pictures| {
            // However long each takes on a busy machine.
            let next = || drop(pictures.recv_timeout(Duration::from_secs(300)).expect("a picture"));
            for id in 0..50 {
                client.show(view(id, 4));
                match id {
                    0..3 => next(),
                    _ => std::thread::sleep(Duration::from_millis(5)),
                }
            }
            assert!(pictures.recv_timeout(2 * SETTLED).is_err(), "a fourth");
            client.acknowledge();
            next();
            assert!(pictures.recv_timeout(2 * SETTLED).is_err(), "one for each that was shown");
        });
    }

    #[test]
    fn pictures_are_as_fine_as_there_is_time_for_and_their_size_does_not_waver() {
        let scene = Arc::new(PackedScene::pack(&voxtrace::scenes::generate("city", Some(20_000)).unwrap()).unwrap());
        let frame = View { width: 1280, height: 720, ..view(1, 64) }.frame(&scene, 64).unwrap();
        let mut speed = Speed::default();
        let mut widths = |samples_a_second: f64, most_pixels: f64| {
            let wavering = [1.0, 0.97, 1.04, 0.95, 1.02].map(|share| samples_a_second * share);
            let widths = wavering.map(|samples| {
                speed.samples = samples;
                speed.quick(&frame, most_pixels).width
            });
            assert!(widths.iter().all(|&width| width == widths[0]), "{widths:?}");
            widths[0]
        };
        let whole = 1280.0 * 720.0 / MOVING.as_secs_f64();
        assert_eq!(widths(1.5 * whole, f64::MAX), 1280);
        assert_eq!(widths(1.5 * whole, 1280.0 * 720.0 / 1.44), 1067, "what follows is slower");
        assert!((600..=740).contains(&widths(whole / 3.0, f64::MAX)));
        assert_eq!(widths(1.0, f64::MAX), 128);
        assert_eq!(widths(1.5 * whole, f64::MAX), 1280, "and back");
        speed.samples = 9.0 * whole;
        assert_eq!(speed.quick(&frame, f64::MAX).samples, MOST_MOVING_SAMPLES);
    }

    #[test]
    fn a_client_that_left_stops_what_is_traced() {
        with_session(|client, pictures| {
            // Hours of work, of which the first picture comes soon.
            client.show(View { width: 1920, height: 1080, ..view(1, 4096) });
            pictures.recv().unwrap();
            client.acknowledge();
            std::thread::sleep(2 * SETTLED);
        });
    }
}
