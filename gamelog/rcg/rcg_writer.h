// Writes a game log (rcg, all versions) while a match runs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/io/byte_sink.h"
#include "gamelog/rcl/rcl_writer.h"
#include "gamelog/record/frame.h"
#include "gamelog/record/rcg_version.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::gamelog {

/// The part of the result line and of log file names with teams and score: `A_1-vs-B_0`; `null` for
/// a team that never connected. After a level score, the penalty score follows if both teams took
/// kicks: `A_0_2-vs-B_0_1` (docs/spec/log-formats.md 1.12).
std::string match_name(const TeamFrames& teams);

/// Parameters for the log: paths, file names and start commands have their defaults, so that a log
/// does not depend on where and by whom a match was played.
soccer::ServerParams without_local_paths(const soccer::ServerParams& params);

/// Start of the match as written in logs. Constant by default, so that equal matches give equal
/// logs.
struct LogDate {
  std::string minute = "197001010000";              ///< in the result message
  std::string second = "1970-01-01T00:00:00+0000";  ///< in JSON
};

/// The version for a value of server::game_log_version: 1 to 6, or -1 for JSON. Nothing for another
/// number.
std::optional<RcgVersion> rcg_version(int game_log_version);

/// Selects the records of a log (docs/spec/simulation-model.md 12.4, docs/spec/log-formats.md 1.4
/// to 1.10) and writes them into `sink`, which must outlive the writer. The bytes depend only on
/// the arguments.
class RcgWriter {
 public:
  explicit RcgWriter(base::ByteSink& sink, RcgVersion version = RcgVersion::kV6, LogDate date = {});

  /// Called once, before everything else.
  void write_header(const soccer::ServerParams& server, const soccer::PlayerParams& player,
                    const std::vector<soccer::PlayerType>& types);

  /// Called once per simulation step, in every play mode. Writes nothing before kick-off and only
  /// the first frame after time_over. Adds records of play mode and teams when they change.
  void write_step(const Frame& frame);

  /// Writes a message at the current position of the log.
  void write_message(Stamp stamp, int board, std::string_view text);

  /// Called once, after everything else: writes the result.
  void write_end(const Frame& last);

 private:
  bool is_binary() const { return version_ <= RcgVersion::kV3; }
  void add_play_mode(const Frame& frame);
  void add_teams(const Frame& frame);
  void add_show(const Frame& frame);
  void flush();

  base::ByteSink& sink_;
  RcgVersion version_;
  LogDate date_;
  std::string line_;
  soccer::PlayMode written_mode_ = soccer::PlayMode::kNull;
  bool team_written_ = false;
  TeamFrames written_teams_;
};

}  // namespace cls::gamelog
