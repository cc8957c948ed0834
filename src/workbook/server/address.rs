//! Where the server listens: on this machine alone.

use std::net::{Ipv4Addr, SocketAddr};

use thiserror::Error;
use tokio::net::TcpListener;

/// The server could not be started or had to stop.
#[derive(Debug, Error)]
pub enum ServerError {
    /// Another program listens on the port.
    #[error(
        "port {port} is already in use, perhaps by another `cargo run`\n\
         next step: stop that program or choose another port, for example `cargo run -- --port {}`",
        other_port(*port)
    )]
    PortInUse {
        /// The port that was asked for.
        port: u16,
    },
    /// The port cannot be had for another reason, for example because it is reserved.
    #[error(
        "cannot listen on 127.0.0.1:{port}: {source}\nnext step: choose another port with `--port`"
    )]
    Port {
        /// The port that was asked for.
        port: u16,
        /// What the system said.
        source: std::io::Error,
    },
    /// The connection broke down as a whole.
    #[error("the server stopped: {0}")]
    Stopped(#[from] std::io::Error),
    /// The system gives no random bytes for the token.
    #[error("the system gives no random bytes, so the server has no token: {0}")]
    Token(#[from] getrandom::Error),
}

/// A free-looking port to propose; the highest port has no successor.
fn other_port(port: u16) -> u16 {
    port.checked_add(1).unwrap_or(3000)
}

/// Listens on `127.0.0.1:port`; port 0 stands for any free port.
///
/// # Errors
///
/// [`ServerError::PortInUse`] or [`ServerError::Port`].
pub async fn listen(port: u16) -> Result<TcpListener, ServerError> {
    let address = SocketAddr::from((Ipv4Addr::LOCALHOST, port));
    TcpListener::bind(address)
        .await
        .map_err(|source| match source.kind() {
            std::io::ErrorKind::AddrInUse => ServerError::PortInUse { port },
            _ => ServerError::Port { port, source },
        })
}
