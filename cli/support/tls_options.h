// Options for TLS connections to Playmakers.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "orchestration/match/options/endpoint.h"

namespace cls::cli {

/// Names of PEM files (empty: not used).
struct TlsOptions {
  std::string authorities;
  std::string certificate;
  std::string key;
  std::string server_name;
};

/// --tls-ca, --tls-cert, --tls-key, --tls-name. Defaults come from the environment (CLS_TLS_CA,
/// ...), which the matches of tournaments inherit.
void add_tls_options(CLI::App& command, TlsOptions& options);

/// Reads the files for a tls:HOST:PORT endpoint; does nothing for others. Prints errors and returns
/// the exit code.
int read_tls_files(orchestration::match::Endpoint& endpoint, const TlsOptions& options);

}  // namespace cls::cli
