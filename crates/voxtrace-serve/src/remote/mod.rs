//! Pictures that the server traces, over a web socket: the client says what it looks at, and gets pictures of it.

mod messages;
mod session;

use crate::refusal::Refusal;
use crate::scenes::{For, Opened};
use crate::server::App;
use axum::body::Bytes;
use axum::extract::ws::{CloseFrame, Message, WebSocket, WebSocketUpgrade, close_code};
use axum::extract::{Path, State};
use axum::response::Response;
use messages::{Greeting, Said};
use session::{Client, Session};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::{OwnedSemaphorePermit, mpsc, watch};
use voxtrace_vulkan::choose_for;

/// Bytes of a client's message.
const LARGEST_MESSAGE: usize = 2048;
/// Seconds over which a client may say more than usual.
const BURST: f64 = 4.0;

/// What the thread that traces gives the socket.
enum Made {
    Greeting(Box<Greeting>),
    Picture(Vec<u8>),
    Failure(String),
}

pub async fn upgrade(
    State(app): State<Arc<App>>,
    Path(name): Path<String>,
    socket: WebSocketUpgrade,
) -> Result<Response, Refusal> {
    let place = app.root.find_scene(&name)?;
    let viewer = Arc::clone(&app.viewers).try_acquire_owned();
    let viewer = viewer.map_err(|_| Refusal::busy("the server traces for as many clients as it may already"))?;
    let opened = app.scenes.open(&place, For::Person).await?;
    let socket = socket.max_message_size(LARGEST_MESSAGE).max_frame_size(LARGEST_MESSAGE);
    // A picture that does not get through is the client's loss.
    let socket = socket.write_buffer_size(0);
    Ok(socket.on_upgrade(move |socket| serve(socket, app, opened, viewer)))
}

async fn serve(mut socket: WebSocket, app: Arc<App>, opened: Arc<Opened>, viewer: OwnedSemaphorePermit) {
    let client = Arc::new(Client::default());
    // Whatever happens here, also where this future is dropped.
    let _leaves = Leaves(Arc::clone(&client));
    let (sender, mut made) = mpsc::channel(2);
    let (of_thread, of_app) = (Arc::clone(&client), Arc::clone(&app));
    let tracing = std::thread::Builder::new().name("voxtrace-remote".into());
    let started = tracing.spawn(move || {
        trace(&of_app, &opened, &of_thread, &sender);
        // The tracer is gone by now.
        drop(viewer);
    });
    let closing = match started {
        Ok(_) => talk(&mut socket, &app, &client, &mut made).await,
        Err(_) => Some((close_code::AGAIN, "the server has no thread left")),
    };
    if let Some((code, reason)) = closing {
        let frame = CloseFrame { code, reason: reason.into() };
        let _ = tokio::time::timeout(Duration::from_secs(1), socket.send(Message::Close(Some(frame)))).await;
    }
}

struct Leaves(Arc<Client>);

impl Drop for Leaves {
    fn drop(&mut self) {
        self.0.leave();
    }
}

/// Why the server hangs up, if the client has not.
type Closing = Option<(u16, &'static str)>;

/// Passes messages on until somebody hangs up.
async fn talk(socket: &mut WebSocket, app: &App, client: &Client, made: &mut mpsc::Receiver<Made>) -> Closing {
    let limits = &app.settings.limits;
    let mut stop = app.stop.clone();
    let every = limits.silence / 4;
    let mut asking = tokio::time::interval_at(tokio::time::Instant::now() + every, every);
    let (mut heard, mut rate) = (Instant::now(), Rate::new(limits.messages));
    loop {
        tokio::select! {
            () = stopped(&mut stop) => return Some((close_code::AWAY, "the server stops")),
            message = socket.recv() => {
                let Some(Ok(message)) = message else { return None };
                heard = Instant::now();
                if !rate.allows(heard) {
                    return Some((close_code::POLICY, "too many messages"));
                }
                match message {
                    Message::Text(text) => match serde_json::from_str(&text) {
                        Ok(Said::View(view)) => client.show(view),
                        Ok(Said::Ack { .. }) => client.acknowledge(),
                        Err(_) => return Some((close_code::POLICY, "a message is not understood")),
                    },
                    Message::Binary(_) => return Some((close_code::UNSUPPORTED, "messages are text")),
                    Message::Close(_) => return None,
                    Message::Ping(_) | Message::Pong(_) => {}
                }
            }
            made = made.recv() => {
                let message = match made {
                    None => return Some((close_code::NORMAL, "")),
                    Some(Made::Picture(bytes)) => Message::Binary(Bytes::from(bytes)),
                    Some(Made::Greeting(greeting)) => Message::Text(as_json(&*greeting).into()),
                    Some(Made::Failure(line)) => {
                        let said = as_json(&serde_json::json!({ "type": "error", "message": line }));
                        let _ = tokio::time::timeout(limits.unread, socket.send(Message::Text(said.into()))).await;
                        return Some((close_code::ERROR, "tracing failed"));
                    }
                };
                match tokio::time::timeout(limits.unread, socket.send(message)).await {
                    Ok(Ok(())) => {}
                    _ => return None,
                }
            }
            _ = asking.tick() => {
                let is_silent = heard.elapsed() > limits.silence;
                if is_silent || !matches!(tokio::time::timeout(limits.unread, socket.send(Message::Ping(Bytes::new()))).await, Ok(Ok(()))) {
                    return None;
                }
            }
        }
    }
}

/// Waits until the server is asked to stop.
async fn stopped(stop: &mut watch::Receiver<bool>) {
    // Without a sender it has ended.
    let _ = stop.wait_for(|stops| *stops).await;
}

fn as_json(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).expect("numbers and texts")
}

/// Traces until the client has left.
fn trace(app: &App, opened: &Opened, client: &Client, sender: &mpsc::Sender<Made>) {
    let (scene, samples) = (&opened.scene, app.settings.samples);
    let done = choose_for(&app.settings.tracer, scene).map_err(Into::into).and_then(|mut choice| {
        let greeting = Greeting::new(scene, choice.reason, samples);
        if sender.blocking_send(Made::Greeting(Box::new(greeting))).is_err() {
            return Ok(());
        }
        let mut send = |picture| sender.blocking_send(Made::Picture(picture)).is_ok();
        Session { scene, tracer: &mut *choice.tracer, client, samples, send: &mut send }.run()
    });
    if let Err(error) = done {
        let _ = sender.blocking_send(Made::Failure(error.to_string()));
    }
}

/// Counts what a client says: so many messages a second, and for some seconds more.
struct Rate {
    a_second: f64,
    left: f64,
    last: Instant,
}

impl Rate {
    fn new(a_second: u32) -> Self {
        let a_second = f64::from(a_second);
        Self { a_second, left: a_second * BURST, last: Instant::now() }
    }

    fn allows(&mut self, now: Instant) -> bool {
        let passed = now.duration_since(self.last).as_secs_f64();
        self.left = (self.left + passed * self.a_second).min(self.a_second * BURST) - 1.0;
        self.last = now;
        self.left >= 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_client_may_say_so_much_a_second_and_for_some_seconds_more() {
        let (mut rate, start) = (Rate::new(10), Instant::now());
        rate.last = start;
        assert!((0..40).all(|_| rate.allows(start)), "four seconds' worth at once");
        assert!(!rate.allows(start));
        assert!(rate.allows(start + Duration::from_secs(1)), "later it may speak again");
        let steady = (1..1000).map(|number| start + Duration::from_secs(5) + Duration::from_millis(number * 100));
        assert!(steady.into_iter().all(|at| rate.allows(at)));
    }
}
