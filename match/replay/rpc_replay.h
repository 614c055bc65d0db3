// A recorded match asked again: which replies of a Playmaker differ now.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "match/terms/endpoint.h"
#include "proto/recording_file.h"
#include "soccer/side.h"

namespace cls::match {

struct ReplayOptions {
  std::string file;
  Endpoint endpoint;
  /// The side of the calls; else the only side with calls, the side that was not a mock, or the
  /// left.
  std::optional<soccer::Side> side;
  std::optional<int> cycle;  ///< only decisions of this cycle
  std::optional<int> agent;  ///< only calls of this player
  int rpc_deadline_ms = 10'000;
  double start_timeout_s = 20.0;
  std::filesystem::path folder;  ///< for the log of a Playmaker that is started
};

/// One reply that is not what it was.
struct ReplyDifference {
  int step = 0;
  int cycle = 0;  ///< of the State; 0 for the hand-shake
  int agent = 0;
  std::string rpc;
  std::vector<std::string>
      fields;  ///< "actions[0].dash.power: 100 -> 80", or why there is no reply
};

struct ReplayResult {
  recording::RecordingHeader header;
  soccer::Side side = soccer::Side::kLeft;
  std::int64_t calls = 0;
  std::int64_t same = 0;
  std::int64_t skipped = 0;                  ///< calls that had no reply when they were recorded
  std::int64_t answered = 0;                 ///< of these, with a reply now
  std::vector<ReplyDifference> failing;      ///< the others of these: why they fail again
  std::vector<ReplyDifference> differences;  ///< in the order of the recording
  bool interrupted = false;
  std::string file_error;  ///< why the recording cannot be asked again; empty: it can

  bool passed() const { return file_error.empty() && differences.empty() && failing.empty(); }
};

/// Asks everything again, the calls of a cycle together as in a match. Identities
/// (register_response) are those that the Playmaker gives now. The error is about a Playmaker that
/// cannot be reached; one of the file is ReplayResult::file_error.
base::Result<ReplayResult> replay_recording(const ReplayOptions& options,
                                            const std::atomic<int>& stop_signal);

/// The document `cls.replay/1`.
std::string to_json(const ReplayResult& result);
/// A summary and the first `most` differences.
std::string to_text(const ReplayResult& result, std::size_t most);

}  // namespace cls::match
