// Soccer server and mode of a match: `--server`, `--mode`.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"

namespace cls::match {

/// `--server embedded|rcssserver|PATH|HOST:PORT`.
struct ServerChoice {
  enum class Kind {
    kEmbedded,  ///< of cls
    kProgram,   ///< rcssserver, or a program with its options, started by cls
    kAddress,   ///< a running server
  };

  Kind kind = Kind::kEmbedded;
  std::string text = "embedded";
  std::string program;  ///< kProgram: a name on PATH, or a path
  std::string host;     ///< kAddress
  int port = 0;         ///< kAddress: of the players
};

/// A name without slash and colon is a program on PATH. The error suggests a correction.
base::Result<ServerChoice> parse_server(std::string_view text);

/// `--mode lockstep|synch|realtime`.
enum class MatchMode {
  kLockstep,  ///< embedded server in this process, as fast as the slowest agent, deterministic
  kSynch,     ///< over UDP; the server waits for (done) of all clients
  kRealtime,  ///< over UDP, 100 ms a cycle
};

std::string_view name(MatchMode mode);
base::Result<MatchMode> parse_mode(std::string_view text);

}  // namespace cls::match
