//! Serves the team until SIGTERM or Ctrl-C: ./run --port N [--coach]
mod actions;
mod decide;
mod service;
mod situation;
mod wire;

use std::time::Duration;

use protos::game_server::GameServer;
use service::Playmaker;
use wire::{protos, team};
use team::team_playmaker_server::TeamPlaymakerServer;
use tokio::net::TcpListener;
use tokio::signal::unix::{signal, SignalKind};
use tonic::transport::server::TcpIncoming;

const GRACE: Duration = Duration::from_secs(1); // for calls in flight

fn options() -> Option<(u16, bool)> {
    let (mut port, mut with_coach) = (50051, false);
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--coach" => with_coach = true,
            "--port" => port = arguments.next()?.parse().ok()?,
            _ => return None,
        }
    }
    Some((port, with_coach))
}

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn std::error::Error>> {
    let Some((port, with_coach)) = options() else {
        eprintln!("usage: run [--port N] [--coach]");
        std::process::exit(2);
    };
    service::remember_panics();
    let listener = TcpListener::bind(("127.0.0.1", port)).await?;
    let (mut terminate, mut interrupt) =
        (signal(SignalKind::terminate())?, signal(SignalKind::interrupt())?);
    println!("listening on {}", listener.local_addr()?);
    // A reply that waits for the acknowledgment of the one before takes 40 ms.
    let incoming = TcpIncoming::from(listener).with_nodelay(Some(true));
    let playmaker = Playmaker { with_coach };
    let stop = async move {
        tokio::select! { _ = terminate.recv() => (), _ = interrupt.recv() => () }
        tokio::spawn(async {
            tokio::time::sleep(GRACE).await;
            std::process::exit(0);
        });
    };
    tonic::transport::Server::builder()
        .add_service(GameServer::new(playmaker))
        .add_service(TeamPlaymakerServer::new(playmaker))
        .serve_with_incoming_shutdown(incoming, stop)
        .await?;
    Ok(())
}
