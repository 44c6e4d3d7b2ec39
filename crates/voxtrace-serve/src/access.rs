//! Who is answered: requests under a name of this machine, of pages that come from here, by who knows the token. And the headers that every answer has.

use crate::refusal::Refusal;
use crate::server::App;
use crate::settings::{Settings, is_loopback};
use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, StatusCode, Uri, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use std::net::{IpAddr, SocketAddr};
use std::sync::Arc;
use subtle::ConstantTimeEq;

/// Bytes of a token that is made.
const TOKEN_BYTES: usize = 24;

/// Of every answer. The page's own scripts and styles, and no others; no page may frame it or read it.
const HEADERS: [(HeaderName, &str); 8] = [
    (
        header::CONTENT_SECURITY_POLICY,
        "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob:; connect-src 'self'; worker-src 'self'; base-uri \
         'none'; form-action 'none'; frame-ancestors 'none'",
    ),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::X_FRAME_OPTIONS, "DENY"),
    (header::REFERRER_POLICY, "no-referrer"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-embedder-policy"), "require-corp"),
    (HeaderName::from_static("permissions-policy"), "camera=(), microphone=(), geolocation=()"),
];

/// What a request must have.
#[derive(Clone, Debug)]
pub struct Access {
    is_loopback: bool,
    /// Lower case.
    host_names: Vec<String>,
    token: Option<String>,
    /// Cookies are those of a machine, whatever the port.
    cookie: String,
}

impl Access {
    /// For a server that listens at `address`.
    pub fn new(settings: &Settings, address: SocketAddr) -> Self {
        let token = settings.token.clone().or_else(|| (!settings.is_loopback()).then(new_token));
        Self {
            is_loopback: is_loopback(address.ip()),
            host_names: settings.host_names.iter().map(|name| name.to_ascii_lowercase()).collect(),
            token,
            cookie: format!("voxtrace-{}", address.port()),
        }
    }

    pub fn token(&self) -> Option<&str> {
        self.token.as_deref()
    }

    /// Whether a `Host` (or the authority of an address) is one of this machine's. A name that an attacker's server resolves to it is none; an address is not
    /// resolved.
    fn is_ours(&self, host: &str) -> bool {
        let name = match host.strip_prefix('[') {
            Some(rest) => rest.split(']').next().unwrap_or_default(),
            None => host.split(':').next().unwrap_or_default(),
        };
        let name = name.to_ascii_lowercase();
        let is_address = name.parse::<IpAddr>().is_ok_and(|address| !self.is_loopback || is_loopback(address));
        is_address || name == "localhost" || self.host_names.contains(&name)
    }

    /// Why a request is not answered.
    fn check(&self, method: &Method, uri: &Uri, headers: &HeaderMap) -> Result<(), Refusal> {
        let forbidden = |line: &str| Err(Refusal::new(StatusCode::FORBIDDEN, line));
        let text = |name| headers.get(name).map(|value: &HeaderValue| value.to_str().unwrap_or("?"));
        let hosts = headers.get_all(header::HOST).iter().count();
        let Some(host) = text(header::HOST).filter(|_| hosts == 1) else {
            return Err(Refusal::new(StatusCode::BAD_REQUEST, "a request has one Host"));
        };
        if !self.is_ours(host) || uri.authority().is_some_and(|authority| !self.is_ours(authority.as_str())) {
            return forbidden("this server does not answer under that name; --host-name allows one");
        }
        // Of a page elsewhere, also one that this machine serves on another port.
        let origin = text(header::ORIGIN);
        let is_same = |origin: &str| {
            let of = origin.strip_prefix("http://").or_else(|| origin.strip_prefix("https://"));
            of.is_some_and(|of| of.eq_ignore_ascii_case(host))
        };
        if origin.is_some_and(|origin| !is_same(origin)) {
            return forbidden("pages of other origins are not answered");
        }
        let is_visit = method == Method::GET && uri.path() == "/" && text(SEC_FETCH_MODE) == Some("navigate");
        if !is_visit && matches!(text(SEC_FETCH_SITE), Some("cross-site" | "same-site")) {
            return forbidden("pages of other origins are not answered");
        }
        if !self.is_known(uri, headers) {
            let line = "open the address that `voxtrace serve` printed: it has the token";
            return Err(Refusal::new(StatusCode::UNAUTHORIZED, line));
        }
        Ok(())
    }

    /// Whether a request has the token: in its address, in a cookie, or as a bearer's.
    fn is_known(&self, uri: &Uri, headers: &HeaderMap) -> bool {
        let Some(token) = &self.token else { return true };
        let cookies = headers.get_all(header::COOKIE).iter().filter_map(|value| value.to_str().ok());
        let mut cookies = cookies.flat_map(|line| line.split(';')).filter_map(|pair| pair.trim().split_once('='));
        let bearer = headers.get(header::AUTHORIZATION).and_then(|value| value.to_str().ok());
        let bearer = bearer.and_then(|value| value.strip_prefix("Bearer "));
        let is_right = |given: &str| bool::from(given.as_bytes().ct_eq(token.as_bytes()));
        token_of(uri).is_some_and(is_right)
            || bearer.is_some_and(is_right)
            || cookies.any(|(name, value)| name == self.cookie && is_right(value))
    }

    /// The answer to a visit with the token in the address: the token goes into a cookie, which no script reads.
    ///
    /// The cookie is `Lax`: a link in somebody's mail is a visit from another site, the redirect belongs to it, and browsers send no `Strict` cookie along.
    /// Other sites get no more by it than visits by GET: these change nothing, and their answers are shown to the person alone (in no frame, and in no window
    /// that the other site holds). Writes and web sockets are no visits: browsers send them without the cookie, and with their `Origin`, which
    /// [`Self::check`] refuses.
    fn welcome(&self, method: &Method, uri: &Uri) -> Option<Response> {
        let token = self.token.as_ref()?;
        if method != Method::GET || uri.path() != "/" || token_of(uri).is_none() {
            return None;
        }
        let cookie = format!("{}={token}; Path=/; HttpOnly; SameSite=Lax", self.cookie);
        Some((StatusCode::SEE_OTHER, [(header::SET_COOKIE, cookie), (header::LOCATION, "/".into())]).into_response())
    }
}

const SEC_FETCH_SITE: HeaderName = HeaderName::from_static("sec-fetch-site");
const SEC_FETCH_MODE: HeaderName = HeaderName::from_static("sec-fetch-mode");

/// The token in an address: its characters need no decoding.
fn token_of(uri: &Uri) -> Option<&str> {
    uri.query()?.split('&').find_map(|pair| pair.strip_prefix("token="))
}

/// A token that nobody guesses, of letters and digits.
fn new_token() -> String {
    let mut bytes = [0; TOKEN_BYTES];
    getrandom::fill(&mut bytes).expect("the system gives random bytes");
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Checks each request before anything else looks at it, and gives each answer its headers.
pub async fn guard(State(app): State<Arc<App>>, request: Request, next: Next) -> Response {
    let (method, uri) = (request.method().clone(), request.uri().clone());
    let mut response = match app.access.check(&method, &uri, request.headers()) {
        Err(refusal) => refusal.into_response(),
        Ok(()) => match app.access.welcome(&method, &uri) {
            Some(welcome) => welcome,
            None => next.run(request).await,
        },
    };
    let headers = response.headers_mut();
    for (name, value) in HEADERS {
        headers.insert(name, HeaderValue::from_static(value));
    }
    headers.entry(header::CACHE_CONTROL).or_insert(HeaderValue::from_static("no-store"));
    response
}

#[cfg(test)]
mod tests {
    use super::*;

    fn access(listen: &str, token: Option<&str>) -> Access {
        let listen: SocketAddr = listen.parse().unwrap();
        let settings = Settings {
            token: token.map(str::to_owned),
            host_names: vec!["Scans.example".into()],
            ..Settings::new("", listen)
        };
        Access::new(&settings, listen)
    }

    #[test]
    fn names_that_others_can_point_at_this_machine_are_not_ours() {
        let local = access("127.0.0.1:8080", None);
        for host in ["localhost:8080", "LOCALHOST", "127.0.0.1:8080", "[::1]:8080", "127.3.4.5", "scans.example:80"] {
            assert!(local.is_ours(host), "{host}");
        }
        for host in [
            "evil.example",
            "localhost.evil.example",
            "10.0.0.5:8080",
            "",
            "[",
            "127.0.0.1.evil.example",
            "user@localhost",
        ] {
            assert!(!local.is_ours(host), "{host}");
        }
        let open = access("0.0.0.0:8080", None);
        assert!(open.is_ours("10.0.0.5:8080") && !open.is_ours("evil.example"));
    }

    #[test]
    fn a_token_is_made_for_other_addresses_than_loopback_and_is_another_each_time() {
        assert_eq!(access("127.0.0.1:1", None).token(), None);
        assert_eq!(access("[::1]:1", None).token(), None);
        let made = ["0.0.0.0:1", "10.0.0.5:1", "[::]:1"].map(|listen| access(listen, None).token().unwrap().to_owned());
        assert!(made.iter().all(|token| token.len() == 2 * TOKEN_BYTES));
        assert!(made[0] != made[1] && made[1] != made[2]);
    }
}
