// Files of a project that nobody else shall have.
#pragma once

#include <filesystem>

namespace cls::cli {

/// True for what holds passwords, tokens or private keys: .env, .netrc, .npmrc, .ssh, id_rsa,
/// credentials.json, *.key, *.pem without public certificates only, ... Goes by names; of *.pem
/// also by contents.
bool is_private(const std::filesystem::path& path);

}  // namespace cls::cli
