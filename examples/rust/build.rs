//! Generates the messages and services of the wire from the .proto files; needs no protoc.
use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = if Path::new("proto").is_dir() { "proto" } else { "../../proto" };
    println!("cargo:rerun-if-changed={folder}");
    let files = protox::compile(["playmaker.proto", "team_playmaker.proto"], [folder])?;
    tonic_prost_build::configure().build_client(false).compile_fds(files)?;
    Ok(())
}
