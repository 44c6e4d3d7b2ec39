//! The files of the page itself, which are in the program, and those of the element, which lie in a folder.

use crate::files;
use crate::places::{Place, is_plain};
use crate::refusal::Refusal;
use crate::server::App;
use axum::extract::{Path, State};
use axum::http::{HeaderMap, Method, header};
use axum::response::{IntoResponse, Response};
use std::sync::Arc;

/// The page's files: name, type and content.
const FILES: [(&str, &str, &str); 7] = [
    ("index.html", "text/html; charset=utf-8", include_str!("../page/index.html")),
    ("icon.svg", "image/svg+xml", include_str!("../page/icon.svg")),
    ("page.css", "text/css; charset=utf-8", include_str!("../page/page.css")),
    ("page.js", "text/javascript; charset=utf-8", include_str!("../page/page.js")),
    ("view.js", "text/javascript; charset=utf-8", include_str!("../page/view.js")),
    ("remote.js", "text/javascript; charset=utf-8", include_str!("../page/remote.js")),
    ("camera.js", "text/javascript; charset=utf-8", include_str!("../page/camera.js")),
];

pub async fn index() -> Result<Response, Refusal> {
    file(Path("index.html".into())).await
}

pub async fn file(Path(name): Path<String>) -> Result<Response, Refusal> {
    let known = FILES.into_iter().find(|(known, ..)| *known == name);
    let (_, kind, text) = known.ok_or_else(|| Refusal::nothing(&name))?;
    Ok(([(header::CONTENT_TYPE, kind), (header::CACHE_CONTROL, "no-cache")], text).into_response())
}

/// A file of the element `<voxtrace-viewer>`.
pub async fn element(
    State(app): State<Arc<App>>,
    Path(name): Path<String>,
    method: Method,
    asked: HeaderMap,
) -> Result<Response, Refusal> {
    let kind = match name.rsplit_once('.') {
        Some((_, "js")) => "text/javascript; charset=utf-8",
        Some((_, "wasm")) => "application/wasm",
        Some((_, "wgsl")) => "text/wgsl; charset=utf-8",
        _ => return Err(Refusal::nothing(&name)),
    };
    let folder = app.settings.element.as_ref().filter(|_| is_plain(&name)).ok_or_else(|| Refusal::nothing(&name))?;
    let path = folder.join(&name);
    let metadata = tokio::fs::metadata(&path).await.ok().filter(std::fs::Metadata::is_file);
    let metadata = metadata.ok_or_else(|| Refusal::nothing(&name))?;
    files::respond(&Place { name, path, metadata }, &method, &asked, kind).await
}
