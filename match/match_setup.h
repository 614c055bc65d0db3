// Server and sides of a match from its options.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>

#include "base/io/byte_sink.h"
#include "base/result.h"
#include "match/match.h"
#include "match/server/embedded_server.h"
#include "match/server/external_server.h"

namespace cls::match {

/// The parts of both kinds of matches. Everything must outlive the match.
struct MatchSetup {
  const MatchOptions& options;
  const TeamNames& names;
  std::uint64_t seed = 0;
  const std::atomic<int>& stop_signal;
  process::ProcessHost* host = nullptr;  ///< for `run:` and `team:` sides and external servers
  std::filesystem::path folder = {};     ///< for their logs
};

/// The logs of a match in lockstep; null: none. All must outlive the match.
struct LockstepLogs {
  base::ByteSink* game_log = nullptr;
  base::ByteSink* text_log = nullptr;
  EventRecorder* events = nullptr;  ///< null: none
};

/// A match on the embedded server in this process. Starts the Playmakers of `run:` sides.
base::Result<std::unique_ptr<Match>> make_lockstep_match(const MatchSetup& setup,
                                                         const LockstepLogs& logs);

/// A match over UDP as planned. Starts the Playmakers of `run:` sides.
base::Result<std::unique_ptr<Match>> make_external_match(const MatchSetup& setup, MatchPlan plan);

}  // namespace cls::match
