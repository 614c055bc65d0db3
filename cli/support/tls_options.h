// The options of commands that speak to Playmakers by TLS.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "orchestration/match/options/endpoint.h"

namespace cls::cli {

/// Names of PEM files; empty ones are not used.
struct TlsOptions {
  std::string authorities;
  std::string certificate;
  std::string key;
  std::string server_name;
};

/// --tls-ca, --tls-cert, --tls-key, --tls-name; what is not given comes from the environment
/// (CLS_TLS_CA and so on), which reaches the matches of tournaments as well.
void add_tls_options(CLI::App& command, TlsOptions& options);

/// Reads the files for an endpoint of the form tls:HOST:PORT; nothing to do for others. Prints what
/// is wrong; the exit code.
int read_tls_files(orchestration::match::Endpoint& endpoint, const TlsOptions& options);

}  // namespace cls::cli
