//! A server in this process, and a client that sends what no browser would.

use std::fs;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::Path;
use std::time::Duration;

use cagd::workbook::server::{self, Book, State, Token};
use tempfile::TempDir;
use tokio::sync::watch;

/// The longest that a test waits for an answer; nothing that is answered at all takes as long.
pub(crate) const PATIENCE: Duration = Duration::from_secs(60);

/// A server with two small pages; it ends with the process.
pub(crate) struct Server {
    pub(crate) address: SocketAddr,
    pub(crate) token: Token,
    folder: TempDir,
    // Dropped, it would tell the pages that nothing will change any more.
    _state: watch::Sender<State>,
}

/// What stands on the page.
pub(crate) const PAGE: &str = "<html><head><title>A page</title></head><body><main><p>Read me.</p></main>\
     <script>inside();</script></body></html>";

impl Server {
    pub(crate) fn start() -> Self {
        Self::of(Path::new(env!("CARGO_MANIFEST_DIR")))
    }

    /// A server of the workbook at this place.
    pub(crate) fn of(root: &Path) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let pages = folder.path().join("site");
        fs::create_dir_all(pages.join("bezier")).expect("folders");
        for page in ["index.html", "bezier/shape.html", "404.html"] {
            fs::write(pages.join(page), PAGE).expect("a page");
        }
        fs::write(folder.path().join("secret.txt"), "a secret").expect("a file");
        let token = Token::random().expect("random bytes");
        let known = State {
            version: "1".into(),
            news: "1".into(),
            ready: true,
            error: None,
        };
        let (sender, state) = watch::channel(known);
        let book = Book {
            root: root.to_path_buf(),
            folder: pages,
            answers: folder.path().join("answers"),
            state,
            token: token.clone(),
        };
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .enable_all()
            .build()
            .expect("threads");
        let listener = runtime.block_on(server::listen(0)).expect("a free port");
        let address = listener.local_addr().expect("it has an address");
        std::thread::spawn(move || {
            runtime
                .block_on(server::serve(listener, book, std::future::pending()))
                .expect("it serves");
        });
        Self {
            address,
            token,
            folder,
            _state: sender,
        }
    }

    /// The folder of the reader's answers.
    pub(crate) fn answers(&self) -> std::path::PathBuf {
        self.folder.path().join("answers")
    }

    /// A file of the built book.
    pub(crate) fn path(&self, file: &str) -> std::path::PathBuf {
        self.folder.path().join("site").join(file)
    }

    /// The headers that a browser with the cookie sends from a page of the book.
    pub(crate) fn reader(&self) -> Vec<(String, String)> {
        let port = self.address.port();
        vec![
            ("Host".into(), self.address.to_string()),
            ("Origin".into(), format!("http://{}", self.address)),
            (
                "Cookie".into(),
                format!("workbook-{port}={}", self.token.text()),
            ),
        ]
    }

    /// The headers of a visitor without the token.
    pub(crate) fn visitor(&self) -> Vec<(String, String)> {
        vec![("Host".into(), self.address.to_string())]
    }

    /// Opens a connection and writes a request, without waiting for the answer.
    pub(crate) fn send(&self, line: &str, headers: &[(String, String)], body: &str) -> TcpStream {
        let mut stream = TcpStream::connect(self.address).expect("the server listens");
        stream
            .set_read_timeout(Some(PATIENCE))
            .expect("a time limit");
        let mut request = format!("{line} HTTP/1.1\r\nConnection: close\r\n");
        for (name, value) in headers {
            request.push_str(&format!("{name}: {value}\r\n"));
        }
        if !body.is_empty() {
            request.push_str("Content-Type: application/json\r\n");
            request.push_str(&format!("Content-Length: {}\r\n", body.len()));
        }
        request.push_str("\r\n");
        request.push_str(body);
        stream.write_all(request.as_bytes()).expect("it is read");
        stream
    }

    /// Sends a request and reads the answer.
    pub(crate) fn ask(&self, line: &str, headers: &[(String, String)], body: &str) -> Answer {
        Answer::of(self.send(line, headers, body))
    }

    /// The book can be read.
    #[track_caller]
    pub(crate) fn assert_readable(&self) {
        let answer = self.ask("GET /bezier/shape.html", &self.visitor(), "");
        assert_eq!(answer.status, 200, "{answer:?}");
        assert!(answer.body.contains("Read me."), "{answer:?}");
    }
}

/// The same headers with one set to another value, or left out.
pub(crate) fn with(
    headers: &[(String, String)],
    name: &str,
    value: Option<&str>,
) -> Vec<(String, String)> {
    let mut headers: Vec<_> = headers.iter().filter(|(n, _)| n != name).cloned().collect();
    headers.extend(value.map(|value| (name.to_owned(), value.to_owned())));
    headers
}

/// What the server answered.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) status: u16,
    pub(crate) head: String,
    pub(crate) body: String,
}

impl Answer {
    pub(crate) fn of(mut stream: TcpStream) -> Self {
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).expect("it answers in time");
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let (head, body) = text.split_once("\r\n\r\n").expect("an HTTP answer");
        let status = head
            .split(' ')
            .nth(1)
            .and_then(|status| status.parse().ok());
        Self {
            status: status.unwrap_or_else(|| panic!("no status in {head}")),
            head: head.to_lowercase(),
            body: body.to_owned(),
        }
    }

    /// The value of a header, in small letters.
    pub(crate) fn header(&self, name: &str) -> Option<&str> {
        let start = format!("{name}: ");
        self.head.lines().find_map(|line| line.strip_prefix(&start))
    }
}
