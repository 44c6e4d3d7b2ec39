//! What a server is told: the folder, who may ask, what traces, and how much anybody may use.

use std::net::{IpAddr, SocketAddr};
use std::path::PathBuf;
use std::time::Duration;
use voxtrace_vulkan::Request;

/// What to serve, to whom and with what.
#[derive(Clone, Debug)]
pub struct Settings {
    /// The folder whose scenes are shown.
    pub folder: PathBuf,
    /// Address and port; port 0 is any that is free.
    pub listen: SocketAddr,
    /// What browsers must know to be answered. `None`: whoever reaches a loopback address is; for other addresses a token is made.
    pub token: Option<String>,
    /// Names of this machine under which browsers may ask, beside its addresses and `localhost`.
    pub host_names: Vec<String>,
    /// The folder with the files of the element `<voxtrace-viewer>`: `voxtrace.js` and those beside it. Without it every scene is shown by pictures that
    /// the server traces.
    pub element: Option<PathBuf>,
    /// The folder where thumbnails are kept between runs.
    pub cache: Option<PathBuf>,
    /// What traces for clients.
    pub tracer: Request,
    /// Samples of each pixel of pictures that the server traces, where the view stands still.
    pub samples: u32,
    /// How much anybody may use.
    pub limits: Limits,
}

impl Settings {
    /// A folder on this address, with nothing else asked for.
    pub fn new(folder: impl Into<PathBuf>, listen: SocketAddr) -> Self {
        Self {
            folder: folder.into(),
            listen,
            token: None,
            host_names: Vec::new(),
            element: None,
            cache: None,
            tracer: Request::default(),
            samples: 64,
            limits: Limits::default(),
        }
    }

    /// Whether only this machine can reach the address.
    pub fn is_loopback(&self) -> bool {
        is_loopback(self.listen.ip())
    }
}

/// Whether an address is one of this machine alone.
pub(crate) fn is_loopback(address: IpAddr) -> bool {
    address.to_canonical().is_loopback()
}

/// How much of everything there may be. The command line sets the first three.
#[derive(Clone, Debug)]
pub struct Limits {
    /// Clients for whom the server traces at the same time.
    pub viewers: usize,
    /// Bytes of scenes that are kept in memory; those that are shown stay beyond it.
    pub memory: u64,
    /// Bytes of a file that is uploaded; 0 forbids uploads.
    pub upload: u64,
    /// Connections at the same time; further ones wait to be accepted.
    pub connections: usize,
    /// How long the head of a request may take, and how long a connection may be idle between two.
    pub head: Duration,
    /// How long a part of a request's body may be waited for.
    pub body: Duration,
    /// How long a client may leave what is written to it unread.
    pub unread: Duration,
    /// How long a client of pictures may be silent; it is asked four times in that time.
    pub silence: Duration,
    /// How long requests may go on once the server is asked to stop.
    pub farewell: Duration,
    /// Messages of a client of pictures in a second, in the mean over some seconds.
    pub messages: u32,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            viewers: 8,
            memory: 2 << 30,
            upload: 2 << 30,
            connections: 384,
            head: Duration::from_secs(10),
            body: Duration::from_secs(10),
            unread: Duration::from_secs(30),
            silence: Duration::from_secs(40),
            farewell: Duration::from_secs(3),
            messages: 250,
        }
    }
}
