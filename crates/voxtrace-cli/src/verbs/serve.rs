//! `voxtrace serve`: a page for the scenes of a folder.

use crate::failure::{Failure, reason};
use crate::interrupt;
use crate::parse;
use crate::probes;
use crate::report::Report;
use crate::stdout;
use crate::tracer::TracerArgs;
use std::io::ErrorKind;
use std::net::SocketAddr;
use std::path::PathBuf;
use voxtrace_serve::{Limits, ServeError, Server, Settings};

/// Show the scenes of a folder in a browser: thumbnails, a viewer, files that are dropped, and pictures traced here
///
/// Prints the address to open. Without --listen only this machine can reach it; other addresses need the token that is printed with them. Ctrl-C ends it.
#[derive(clap::Args, Clone, Debug)]
#[command(mut_arg("cluster", |cluster| cluster.hide(true)))]
pub struct ServeArgs {
    /// Folder whose scenes are shown
    #[arg(value_name = "FOLDER", default_value = ".")]
    folder: PathBuf,
    /// Address and port to listen at; port 0 is any that is free
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:8080")]
    listen: SocketAddr,
    /// What browsers must know, at least 16 letters and digits [default: at 127.0.0.1 none, elsewhere one that is made anew]
    #[arg(long, value_name = "TOKEN", env = "VOXTRACE_TOKEN", hide_env_values = true, value_parser = token)]
    token: Option<String>,
    /// A name under which browsers may ask for this machine, beside its addresses and localhost; several times for several
    #[arg(long, value_name = "NAME", value_parser = host_name)]
    host_name: Vec<String>,
    /// Folder of the viewer for pages (voxtrace.js and what lies beside it) [default: `web` beside the program]. Without it, the server traces all pictures
    #[arg(long, value_name = "FOLDER", env = "VOXTRACE_WEB", hide_env_values = true)]
    web: Option<PathBuf>,
    /// Largest file that browsers may upload, for example 500MB; 0 takes none
    #[arg(long, value_name = "BYTES", default_value = "2GB", value_parser = parse::bytes_or_none)]
    max_upload: u64,
    /// Memory for scenes that are kept, for example 8GB; a scene larger than that is refused
    #[arg(long, value_name = "BYTES", default_value = "2GB", value_parser = parse::bytes)]
    memory: u64,
    /// Browsers for which pictures are traced here at the same time
    #[arg(long, value_name = "N", default_value_t = 8, value_parser = clap::value_parser!(u16).range(0..=1000))]
    viewers: u16,
    /// Samples of each pixel of pictures that are traced here, where the view stands still
    #[arg(long, visible_alias = "spp", value_name = "N", default_value_t = 64, value_parser = clap::value_parser!(u32).range(1..=4096))]
    samples: u32,
    #[command(flatten)]
    tracer: TracerArgs,
}

/// A token that needs no coding in addresses.
fn token(text: &str) -> Result<String, String> {
    let is_token = text.len() >= 16 && text.chars().all(|c| c.is_ascii_alphanumeric());
    is_token.then(|| text.to_owned()).ok_or_else(|| "a token has at least 16 letters and digits".into())
}

/// A name that a browser's `Host` can be, whatever its port.
fn host_name(text: &str) -> Result<String, String> {
    let is_name = !text.is_empty() && text.chars().all(|c| c.is_ascii_alphanumeric() || "-._".contains(c));
    is_name
        .then(|| text.to_owned())
        .ok_or_else(|| "a name alone is wanted, without scheme and port: scans.example".into())
}

impl ServeArgs {
    pub fn run(self, report: &mut Report) -> Result<(), Failure> {
        let element = self.web.or_else(beside_program);
        if element.is_none() {
            report.remark("the viewer for pages is not here: the server traces all pictures (--web FOLDER names it)");
        }
        let settings = Settings {
            token: self.token,
            host_names: self.host_name,
            element,
            cache: probes::folder(),
            tracer: self.tracer.request_of_one_machine()?,
            samples: self.samples,
            limits: Limits {
                viewers: self.viewers.into(),
                memory: self.memory,
                upload: self.max_upload,
                ..Limits::default()
            },
            ..Settings::new(&self.folder, self.listen)
        };
        let server = Server::bind(settings).map_err(failure)?;
        report.remark(&format!("serving {}; Ctrl-C ends it", self.folder.display()));
        stdout::print(&format!("{}\n", server.url()));
        server.run(interrupt::is_requested).map_err(failure)
    }
}

/// The viewer for pages as archives of releases have it.
fn beside_program() -> Option<PathBuf> {
    let program = std::env::current_exe().ok()?.canonicalize().ok()?;
    let folder = program.parent()?.join("web");
    folder.join("voxtrace.js").is_file().then_some(folder)
}

fn failure(error: ServeError) -> Failure {
    match &error {
        ServeError::Folder { path, error } => {
            Failure::input(format!("cannot read {}: {}", path.display(), reason(error)))
        }
        ServeError::Listen { error: reason, .. } => {
            let hint = match reason.kind() {
                ErrorKind::AddrInUse => "another program has that port; --listen 127.0.0.1:0 takes one that is free",
                ErrorKind::PermissionDenied => {
                    "ports below 1024 are the system's; --listen 127.0.0.1:8080 needs no rights"
                }
                _ => "--listen takes an address of this machine, or 0.0.0.0 for all of them",
            };
            Failure::other(&error).hint(hint)
        }
        _ => Failure::other(error),
    }
}
