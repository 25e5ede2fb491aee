//! Which requests are answered: those that have the token in their path, name this server as their host, and come from no other page.

/// Most bytes of a request's body.
pub(super) const MOST_BYTES: usize = 64 << 10;

/// The target of a request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Route {
    /// The page.
    Page,
    /// A run.
    Run,
    /// The sections of a run that the first answer did not contain completely.
    Rest,
    /// Cost and error of a run.
    Judge,
    /// Which effects matter.
    Advise,
    /// The scene as text.
    Save,
}

/// A request without its body.
#[derive(Debug, Clone, Default)]
pub(super) struct Head<'a> {
    pub method: &'a str,
    pub url: &'a str,
    /// The values of all headers `Host`, `Origin` and `Content-Type`.
    pub host: Vec<&'a str>,
    pub origin: Vec<&'a str>,
    pub content_type: Vec<&'a str>,
    /// The stated length of the body.
    pub length: Option<usize>,
}

/// HTTP status and reason of a refusal.
pub(super) type Refused = (u16, &'static str);

/// Finds the target of a request. `port` and `token` are those of this server.
///
/// # Errors
/// The refusal. Its text reveals nothing to a page that does not know the token.
pub(super) fn route(head: &Head<'_>, token: &str, port: u16) -> Result<Route, Refused> {
    // A page of another site may let its own host name resolve to 127.0.0.1 (DNS rebinding). The header `Host` then has that name.
    let hosts = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
    if !matches!(head.host[..], [host] if hosts.iter().any(|known| known == host)) {
        return Err((403, "unknown host"));
    }
    let own =
        |origin: &&str| origin.strip_prefix("http://").is_some_and(|host| hosts.iter().any(|known| known == host));
    if !head.origin.iter().all(own) {
        return Err((403, "another origin"));
    }
    let path = head.url.strip_prefix('/').and_then(|path| path.split_once('/'));
    let Some((_, what)) = path.filter(|(given, _)| same(given, token)) else {
        return Err((403, "not without the token: open the address that the program printed"));
    };
    let route = match what {
        "" => Route::Page,
        "run" => Route::Run,
        "rest" => Route::Rest,
        "judge" => Route::Judge,
        "advise" => Route::Advise,
        "save" => Route::Save,
        _ => return Err((404, "no such page")),
    };
    if head.method != if route == Route::Page { "GET" } else { "POST" } {
        return Err((405, "method not allowed"));
    }
    // Before a page of another origin sends this content type, its browser asks with an `OPTIONS` request, which is refused.
    if route != Route::Page && head.content_type[..] != ["application/json"] {
        return Err((415, "the body must be JSON"));
    }
    match head.length {
        Some(length) if length > MOST_BYTES => Err((413, "the body is too large")),
        _ => Ok(route),
    }
}

/// Whether two texts are equal, in a time that does not depend on where they differ.
fn same(a: &str, b: &str) -> bool {
    a.len() == b.len() && a.bytes().zip(b.bytes()).fold(0, |apart, (a, b)| apart | (a ^ b)) == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn good() -> Head<'static> {
        let (host, content_type) = (vec!["127.0.0.1:8000"], vec!["application/json"]);
        Head { method: "POST", url: "/secret/run", host, origin: vec![], content_type, length: Some(2) }
    }

    fn status(head: &Head<'_>) -> u16 {
        route(head, "secret", 8000).map_or_else(|(status, _)| status, |_| 200)
    }

    #[test]
    fn only_requests_with_token_host_and_origin_are_answered() {
        assert_eq!(route(&good(), "secret", 8000), Ok(Route::Run));
        let page = Head { method: "GET", url: "/secret/", content_type: vec![], length: None, ..good() };
        assert_eq!(route(&page, "secret", 8000), Ok(Route::Page));
        for origin in ["http://127.0.0.1:8000", "http://localhost:8000"] {
            assert_eq!(status(&Head { origin: vec![origin], ..good() }), 200, "{origin}");
        }
        for url in ["/", "/secret", "/secre/run", "/secretx/run", "/Secret/run", "//run", "secret/run", ""] {
            assert_eq!(status(&Head { url, ..good() }), 403, "{url}");
        }
        let hosts =
            [vec![], vec!["evil.example:8000"], vec!["127.0.0.1"], vec!["127.0.0.1:8001"], vec!["127.0.0.1:8000"; 2]];
        for host in hosts {
            assert_eq!(status(&Head { host: host.clone(), ..good() }), 403, "{host:?}");
        }
        for origin in
            ["http://127.0.0.1:8001", "https://127.0.0.1:8000", "null", "http://127.0.0.1:8000.evil.example", ""]
        {
            assert_eq!(status(&Head { origin: vec![origin], ..good() }), 403, "{origin}");
        }
    }

    #[test]
    fn other_methods_types_paths_and_large_bodies_are_refused() {
        assert_eq!(status(&Head { method: "GET", ..good() }), 405);
        assert_eq!(status(&Head { method: "OPTIONS", url: "/secret/", ..good() }), 405);
        assert_eq!(status(&Head { content_type: vec!["text/plain"], ..good() }), 415);
        assert_eq!(status(&Head { url: "/secret/../etc", ..good() }), 404);
        assert_eq!(status(&Head { length: Some(MOST_BYTES), ..good() }), 200);
        assert_eq!(status(&Head { length: Some(MOST_BYTES + 1), ..good() }), 413);
    }
}
