// Which soccer server a match is played on, and how its time runs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace cls::orchestration::match {

/// `--server embedded|rcssserver|PATH|HOST:PORT`.
struct ServerChoice {
  enum class Kind {
    kEmbedded,  ///< ours
    kProgram,   ///< rcssserver, or a program that takes its options, started by us
    kAddress,   ///< a server that runs already
  };

  Kind kind = Kind::kEmbedded;
  std::string text = "embedded";
  std::string program;  ///< kProgram: a name to look for on PATH, or a path
  std::string host;     ///< kAddress
  int port = 0;         ///< kAddress: of the players
};

/// A word without slash and colon is a program on PATH; the error suggests what may be meant.
base::Result<ServerChoice> parse_server(std::string_view text);

/// `--mode lockstep|synch|realtime`.
enum class MatchMode {
  kLockstep,  ///< embedded server in our own process, as fast as the slowest agent, repeatable
  kSynch,     ///< over UDP; the server waits for everybody's (done)
  kRealtime,  ///< over UDP, 100 ms a cycle
};

std::string_view name(MatchMode mode);
base::Result<MatchMode> parse_mode(std::string_view text);

}  // namespace cls::orchestration::match
