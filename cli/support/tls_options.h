// Options for TLS connections to Playmakers.
#pragma once

#include "cli/command/command.h"

#include "match/terms/match_options.h"

namespace cls::cli {

/// --tls-ca, --tls-cert, --tls-key, --tls-name. Defaults come from the environment (CLS_TLS_CA,
/// ...), which the matches of tournaments inherit.
void add_tls_options(Command& command, match::TlsFileNames& options);

/// Reads the files for a tls:HOST:PORT endpoint; does nothing for others. Prints errors and returns
/// the exit code.
int read_tls_files(match::Endpoint& endpoint, const match::TlsFileNames& options);

}  // namespace cls::cli
