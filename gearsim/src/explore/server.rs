//! The server: HTTP on 127.0.0.1, a thread for each request, at most one run at a time.

use std::cell::Cell;
use std::io::{self, Read};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use serde::Serialize;
use tiny_http::{Header, Request, Response, Server};

use super::Explorer;
use super::choice::Choice;
use super::guard::{Head, MOST_BYTES, Refused, Route, route};
use crate::page;

/// Time after which a request is ended \[s\].
const RUN: u64 = 10;
const JUDGE: u64 = 20;
const ADVISE: u64 = 60;

/// Most requests that are answered at a time.
const MOST_REQUESTS: usize = 16;

/// Bytes of randomness in the token.
const TOKEN: usize = 16;

/// A scene served to a browser.
pub struct Service {
    explorer: Explorer,
    server: Server,
    port: u16,
    token: String,
    /// The number of the newest run, and of the newest advice. Older ones end.
    runs: AtomicU64,
    advices: AtomicU64,
    answering: AtomicUsize,
}

/// Tells a run whether to go on.
struct Ticket<'a> {
    newest: &'a AtomicU64,
    number: u64,
    until: Instant,
    calls: Cell<u32>,
}

impl Ticket<'_> {
    fn is_newest(&self) -> bool {
        self.newest.load(Ordering::Relaxed) == self.number
    }

    /// Whether the work is still wanted. The clock is read once in 64 calls, since a call comes after every event.
    fn goes_on(&self) -> bool {
        self.calls.set(self.calls.get().wrapping_add(1));
        !self.calls.get().is_multiple_of(64) || (self.is_newest() && Instant::now() < self.until)
    }
}

/// The answer to work that was ended.
#[derive(Serialize)]
struct Ended {
    /// Whether a newer request ended it; else its time was over.
    superseded: bool,
}

impl Service {
    /// Serves `explorer` at a port of 127.0.0.1; 0 for any that is free.
    ///
    /// # Errors
    /// If the port is taken, or the system gives no random numbers.
    pub fn new(explorer: Explorer, port: u16) -> io::Result<Arc<Service>> {
        let mut bytes = [0; TOKEN];
        getrandom::fill(&mut bytes).map_err(|error| io::Error::other(error.to_string()))?;
        let token = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
        let server = Server::http(("127.0.0.1", port)).map_err(io::Error::other)?;
        let address = server.server_addr().to_ip().ok_or_else(|| io::Error::other("no address"))?;
        let (runs, advices, answering) = Default::default();
        Ok(Arc::new(Service { explorer, server, port: address.port(), token, runs, advices, answering }))
    }

    /// The address to open.
    pub fn url(&self) -> String {
        format!("http://127.0.0.1:{}/{}/", self.port, self.token)
    }

    /// Answers requests until [`Service::stop`].
    pub fn serve(self: &Arc<Self>) {
        for request in self.server.incoming_requests() {
            if self.answering.fetch_add(1, Ordering::Relaxed) >= MOST_REQUESTS {
                self.answering.fetch_sub(1, Ordering::Relaxed);
                respond(request, Err((503, "too many requests at a time")));
                continue;
            }
            let service = self.clone();
            // If a request is dropped, because no thread starts or because of a panic, the server answers it with the status 500.
            let answer = move || {
                let _one = Answering(&service.answering);
                service.answer(request);
            };
            if std::thread::Builder::new().spawn(answer).is_err() {
                self.answering.fetch_sub(1, Ordering::Relaxed);
            }
        }
    }

    /// Ends [`Service::serve`].
    pub fn stop(&self) {
        self.server.unblock();
    }

    fn answer(&self, mut request: Request) {
        let content = self.content(&mut request);
        respond(request, content);
    }

    fn content(&self, request: &mut Request) -> Result<Content, Refused> {
        let route = route(&head(request), &self.token, self.port)?;
        if route == Route::Page {
            let mut bytes = vec![];
            let policy = page::explore::write(&self.explorer.scene.name, &mut bytes);
            let policy = policy.map_err(|_| (500, "the page cannot be written"))?;
            return Ok(Content { bytes, kind: "text/html; charset=utf-8", policy });
        }
        let mut body = vec![];
        let read = request.as_reader().take(MOST_BYTES as u64 + 1).read_to_end(&mut body);
        read.map_err(|_| (400, "the body cannot be read"))?;
        if body.len() > MOST_BYTES {
            return Err((413, "the body is too large"));
        }
        let choice: Choice = serde_json::from_slice(&body).map_err(|_| (400, "the body is not a choice"))?;
        self.chosen(route, &choice)
    }

    fn chosen(&self, route: Route, choice: &Choice) -> Result<Content, Refused> {
        let explorer = &self.explorer;
        match route {
            Route::Run => {
                let ticket = ticket(&self.runs, 1, RUN);
                match explorer.run(choice, &|| ticket.goes_on()) {
                    Some(answer) => Content::json(&answer),
                    None if ticket.is_newest() => Content::json(&explorer.too_long(choice, RUN)),
                    None => Content::json(&Ended { superseded: true }),
                }
            }
            Route::Rest => {
                // A newer run ends this request.
                let ticket = ticket(&self.runs, 0, RUN);
                ended_or(&ticket, explorer.rest(choice, &|| ticket.is_newest() && Instant::now() < ticket.until))
            }
            Route::Judge => {
                // A newer run ends the judgement.
                let ticket = ticket(&self.runs, 0, JUDGE);
                ended_or(&ticket, explorer.judge(choice, &|| ticket.goes_on()))
            }
            Route::Advise => {
                // A newer run ends the advice, so that this run has the processor for itself.
                let (run, ticket) = (ticket(&self.runs, 0, ADVISE), ticket(&self.advices, 1, ADVISE));
                ended_or(&ticket, explorer.advise(choice, &|| run.is_newest() && ticket.goes_on()))
            }
            Route::Save => match explorer.saved(choice) {
                Ok(text) => Ok(Content { bytes: text.into_bytes(), kind: "application/toml", policy: nothing() }),
                Err(_) => Err((409, "the scene has mistakes")),
            },
            Route::Page => Err((405, "method not allowed")),
        }
    }
}

/// Increases the newest number by `step`, and returns a ticket with the result as its number. The ticket is valid for `seconds` \[s\].
fn ticket(newest: &AtomicU64, step: u64, seconds: u64) -> Ticket<'_> {
    let number = newest.fetch_add(step, Ordering::Relaxed) + step;
    Ticket { newest, number, until: Instant::now() + Duration::from_secs(seconds), calls: Cell::new(0) }
}

fn ended_or(ticket: &Ticket<'_>, done: Option<impl Serialize>) -> Result<Content, Refused> {
    match done {
        Some(done) => Content::json(&done),
        None => Content::json(&Ended { superseded: !ticket.is_newest() }),
    }
}

/// Counts a request as answered when it is dropped.
struct Answering<'a>(&'a AtomicUsize);

impl Drop for Answering<'_> {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Relaxed);
    }
}

/// The body of an answer.
struct Content {
    bytes: Vec<u8>,
    kind: &'static str,
    /// Its Content-Security-Policy.
    policy: String,
}

impl Content {
    fn json(value: &impl Serialize) -> Result<Content, Refused> {
        let bytes = serde_json::to_vec(value).map_err(|_| (500, "the answer cannot be written"))?;
        Ok(Content { bytes, kind: "application/json", policy: nothing() })
    }
}

/// The policy of answers that are no pages.
fn nothing() -> String {
    "default-src 'none'; frame-ancestors 'none'".into()
}

/// The head of a request.
fn head(request: &Request) -> Head<'_> {
    let all = |name: &'static str| {
        let named = request.headers().iter().filter(|header| header.field.equiv(name));
        named.map(|header| header.value.as_str()).collect()
    };
    Head {
        method: request.method().as_str(),
        url: request.url(),
        host: all("Host"),
        origin: all("Origin"),
        content_type: all("Content-Type"),
        length: request.body_length(),
    }
}

/// Sends the content, or the refusal as text. A browser that has gone away is no error.
fn respond(request: Request, content: Result<Content, Refused>) {
    let (status, content) = match content {
        Ok(content) => (200, content),
        Err((status, reason)) => {
            let bytes = format!("{reason}\n").into_bytes();
            (status, Content { bytes, kind: "text/plain; charset=utf-8", policy: nothing() })
        }
    };
    let headers = [
        ("Content-Type", content.kind),
        ("Content-Security-Policy", &content.policy),
        ("X-Content-Type-Options", "nosniff"),
        ("X-Frame-Options", "DENY"),
        ("Cross-Origin-Resource-Policy", "same-origin"),
        ("Cross-Origin-Opener-Policy", "same-origin"),
        ("Referrer-Policy", "no-referrer"),
        ("Cache-Control", "no-store"),
    ];
    let headers = headers.iter().filter_map(|(name, value)| Header::from_bytes(*name, *value).ok());
    let mut response = Response::from_data(content.bytes).with_status_code(status).with_chunked_threshold(usize::MAX);
    headers.for_each(|header| response.add_header(header));
    let _ = request.respond(response);
}
