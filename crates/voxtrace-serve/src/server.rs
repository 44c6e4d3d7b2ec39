//! The server: what it answers under which address, from its start to its end.

use crate::access::{self, Access};
use crate::connections;
use crate::files;
use crate::info::{Info, LARGEST_FOR_PAGES};
use crate::listing::Listing;
use crate::page;
use crate::places::Root;
use crate::refusal::Refusal;
use crate::remote;
use crate::scenes::{For, Scenes, while_waited_for};
use crate::settings::Settings;
use crate::thumbnails::Thumbnails;
use crate::upload::{self, Uploaded};
use axum::body::{Body, Bytes};
use axum::extract::{Path, Query, State};
use axum::http::{HeaderMap, Method, StatusCode, header};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, put};
use axum::{Json, Router};
use serde::Deserialize;
use serde_json::{Value, json};
use std::io;
use std::net::{SocketAddr, TcpListener};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::{Semaphore, watch};

/// Files that are uploaded, and scenes that are packed for pages, at the same time.
const MOST_UPLOADS: usize = 2;
const MOST_PACKING: usize = 2;
/// How often the server asks whether it is to stop.
const TICK: Duration = Duration::from_millis(50);

/// Why there is no server.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ServeError {
    /// The folder cannot be read.
    #[error("{}: {error}", path.display())]
    Folder {
        /// The folder that was to be served, or that of the element.
        path: PathBuf,
        /// What the system says.
        #[source]
        error: io::Error,
    },
    /// The address cannot be listened at.
    #[error("cannot listen at {address}: {error}")]
    Listen {
        /// The address.
        address: SocketAddr,
        /// What the system says.
        #[source]
        error: io::Error,
    },
    /// The system gives no threads.
    #[error("cannot start: {0}")]
    Start(#[source] io::Error),
}

/// What requests share.
pub(crate) struct App {
    pub settings: Settings,
    pub root: Root,
    pub access: Access,
    pub scenes: Scenes,
    pub thumbnails: Thumbnails,
    pub uploads: Semaphore,
    pub packing: Semaphore,
    pub viewers: Arc<Semaphore>,
    /// Whether the server stops.
    pub stop: watch::Receiver<bool>,
}

/// A server that listens already.
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
    app: Arc<App>,
    stop: watch::Sender<bool>,
}

/// Who the server works for; lives on while it runs.
#[derive(Clone)]
pub struct Viewers {
    free: Arc<Semaphore>,
    all: usize,
}

impl Viewers {
    /// Clients for whom the server traces, or holds a tracer.
    pub fn count(&self) -> usize {
        self.all.saturating_sub(self.free.available_permits())
    }
}

impl Server {
    /// Listens at the address.
    ///
    /// # Errors
    /// If the folder is none, or the address is not to be had.
    pub fn bind(mut settings: Settings) -> Result<Self, ServeError> {
        let root =
            Root::new(&settings.folder).map_err(|error| ServeError::Folder { path: settings.folder.clone(), error })?;
        if let Some(folder) = &settings.element {
            let found = folder.join("voxtrace.js").metadata();
            found.map_err(|error| ServeError::Folder { path: folder.join("voxtrace.js"), error })?;
        }
        let failed = |error| ServeError::Listen { address: settings.listen, error };
        let listener = TcpListener::bind(settings.listen).map_err(failed)?;
        let address = listener.local_addr().map_err(failed)?;
        listener.set_nonblocking(true).map_err(failed)?;
        settings.limits.viewers = settings.limits.viewers.min(Semaphore::MAX_PERMITS);
        let (stop, stopped) = watch::channel(false);
        let app = App {
            access: Access::new(&settings, address),
            scenes: Scenes::new(&settings.limits),
            thumbnails: Thumbnails::new(settings.cache.as_deref()),
            uploads: Semaphore::new(MOST_UPLOADS),
            packing: Semaphore::new(MOST_PACKING),
            viewers: Arc::new(Semaphore::new(settings.limits.viewers)),
            stop: stopped,
            root,
            settings,
        };
        Ok(Self { listener, address, app: Arc::new(app), stop })
    }

    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// What a person opens, with the token where one is needed. Of all addresses of the machine it names the loopback one.
    pub fn url(&self) -> String {
        let mut address = self.address;
        if address.ip().is_unspecified() {
            address.set_ip(if address.is_ipv4() {
                [127, 0, 0, 1].into()
            } else {
                std::net::Ipv6Addr::LOCALHOST.into()
            });
        }
        match self.app.access.token() {
            Some(token) => format!("http://{address}/?token={token}"),
            None => format!("http://{address}/"),
        }
    }

    /// Who it traces for.
    pub fn viewers(&self) -> Viewers {
        Viewers { free: Arc::clone(&self.app.viewers), all: self.app.settings.limits.viewers }
    }

    /// Serves until `is_over` says so; asked every 50 ms. Then it takes no more requests, gives those that are open some seconds, and ends.
    ///
    /// # Errors
    /// If the system gives no threads.
    pub fn run(self, is_over: impl Fn() -> bool) -> Result<(), ServeError> {
        let Self { listener, app, stop, .. } = self;
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(2)
            .max_blocking_threads(32)
            .thread_name("voxtrace-serve")
            .enable_all()
            .build()
            .map_err(ServeError::Start)?;
        let farewell = app.settings.limits.farewell;
        let served = runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(listener).map_err(ServeError::Start)?;
            let limits = app.settings.limits.clone();
            let stopped = app.stop.clone();
            let watched = async {
                while !is_over() {
                    tokio::time::sleep(TICK).await;
                }
                let _ = stop.send(true);
            };
            tokio::join!(connections::serve(listener, router(Arc::clone(&app)), &limits, stopped), watched);
            // Clients of pictures are no requests; each ends by itself now.
            let all = u32::try_from(limits.viewers).unwrap_or(u32::MAX);
            let _ = tokio::time::timeout(farewell, app.viewers.acquire_many(all)).await;
            Ok(())
        });
        runtime.shutdown_timeout(farewell);
        served
    }
}

fn router(app: Arc<App>) -> Router {
    Router::new()
        .route("/", get(page::index))
        .route("/page/{name}", get(page::file))
        .route("/element/{name}", get(page::element))
        .route("/api/server", get(about))
        .route("/api/list", get(list_root))
        .route("/api/list/{*name}", get(list))
        .route("/api/info/{*name}", get(info))
        .route("/api/thumbnail/{*name}", get(thumbnail))
        .route("/api/packed/{*name}", get(packed))
        .route("/api/upload/{*name}", put(take_upload))
        .route("/api/remote/{*name}", get(remote::upgrade))
        .route("/files/{*name}", get(file))
        .fallback(async || Refusal::new(StatusCode::NOT_FOUND, "there is nothing at this address"))
        .method_not_allowed_fallback(async || Refusal::new(StatusCode::METHOD_NOT_ALLOWED, "not by this method"))
        .layer(axum::middleware::from_fn_with_state(Arc::clone(&app), access::guard))
        // Uploads have a limit of their own; nothing else has a body.
        .layer(axum::extract::DefaultBodyLimit::disable())
        .with_state(app)
}

type Shared = State<Arc<App>>;

/// What the page has to know of the server.
async fn about(State(app): Shared) -> Json<Value> {
    let Settings { element, samples, limits, .. } = &app.settings;
    Json(json!({
        "version": env!("CARGO_PKG_VERSION"),
        "folder": app.root.path().file_name().map(|name| name.to_string_lossy()),
        "has_element": element.is_some(),
        "largest_for_pages": LARGEST_FOR_PAGES,
        "largest_upload": limits.upload,
        "samples": samples,
    }))
}

async fn list_root(app: Shared) -> Result<Json<Listing>, Refusal> {
    list(app, Path(String::new())).await
}

async fn list(State(app): Shared, Path(name): Path<String>) -> Result<Json<Listing>, Refusal> {
    let place = app.root.find(&name)?;
    if !place.metadata.is_dir() {
        return Err(Refusal::nothing(&name));
    }
    let options = app.scenes.options().clone();
    let root = app.root.clone();
    while_waited_for(move |_| Listing::of(&root, &place, &options)).await?.map(Json)
}

async fn info(State(app): Shared, Path(name): Path<String>) -> Result<Json<Info>, Refusal> {
    let place = app.root.find_scene(&name)?;
    let opened = app.scenes.open(&place, For::Person).await?;
    Ok(Json(Info::of(&place, &opened)))
}

async fn thumbnail(State(app): Shared, Path(name): Path<String>) -> Result<Response, Refusal> {
    let place = app.root.find_scene(&name)?;
    let jpeg = app.thumbnails.of(&place, &app.scenes).await?;
    Ok(([(header::CONTENT_TYPE, "image/jpeg"), (header::CACHE_CONTROL, "no-cache")], jpeg).into_response())
}

/// A scene as a native file, which pages trace at once, whatever its own format.
async fn packed(State(app): Shared, Path(name): Path<String>) -> Result<Response, Refusal> {
    let place = app.root.find_scene(&name)?;
    let opened = app.scenes.open(&place, For::Person).await?;
    if opened.bytes > LARGEST_FOR_PAGES {
        return Err(Refusal::new(StatusCode::PAYLOAD_TOO_LARGE, "the scene is too large for a page"));
    }
    let _turn = app.packing.acquire().await.map_err(|_| Refusal::busy("the server stops"))?;
    let bytes = while_waited_for(move |_| opened.file()).await?;
    Ok(([(header::CONTENT_TYPE, BYTES)], Bytes::from_owner(Sent(bytes))).into_response())
}

/// Bytes that several clients may be sent at the same time.
struct Sent(Arc<Vec<u8>>);

impl AsRef<[u8]> for Sent {
    fn as_ref(&self) -> &[u8] {
        &self.0
    }
}

/// The type of files that only programs read.
const BYTES: &str = "application/octet-stream";

async fn file(
    State(app): Shared,
    Path(name): Path<String>,
    method: Method,
    asked: HeaderMap,
) -> Result<Response, Refusal> {
    let place = app.root.find_scene(&name)?;
    if !place.metadata.is_file() {
        return Err(Refusal::nothing(&name));
    }
    let mut response = files::respond(&place, &method, &asked, BYTES).await?;
    response.headers_mut().insert(header::CONTENT_DISPOSITION, header::HeaderValue::from_static("attachment"));
    Ok(response)
}

#[derive(Deserialize)]
struct UploadQuery {
    /// Whether a file of that name is written over.
    #[serde(default)]
    replace: bool,
}

async fn take_upload(
    State(app): Shared,
    Path(name): Path<String>,
    Query(query): Query<UploadQuery>,
    body: Body,
) -> Result<(StatusCode, Json<Uploaded>), Refusal> {
    let uploaded = upload::take(&app, &name, query.replace, body).await?;
    Ok((StatusCode::CREATED, Json(uploaded)))
}
