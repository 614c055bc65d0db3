//! The messages and services that build.rs generates.

/// Of playmaker.proto.
#[allow(clippy::all)]
pub mod protos {
    tonic::include_proto!("protos");
}

/// Of team_playmaker.proto.
#[allow(clippy::all)]
pub mod team {
    tonic::include_proto!("cls.playmaker.v1");
}
