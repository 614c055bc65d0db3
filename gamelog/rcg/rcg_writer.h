// Writing a game log (rcg, all versions) while a match runs.
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

/// The part of the result line and of log file names that names the teams and the score:
/// `A_1-vs-B_0`; `null` for a team that never connected; with the penalty score behind a score
/// that is level when both teams took kicks: `A_0_2-vs-B_0_1` (log-formats 1.12).
std::string match_name(const TeamFrames& teams);

/// The parameters as a log shows them: what names folders, files and start commands is at its
/// default, so that a log does not depend on where and by whom a match was played.
soccer::ServerParams without_places(const soccer::ServerParams& params);

/// When the match began, as logs tell it. The same for all matches unless somebody wants to know.
struct LogDate {
  std::string minute = "197001010000";              ///< behind the result
  std::string second = "1970-01-01T00:00:00+0000";  ///< in JSON
};

/// What server::game_log_version asks for: 1 to 6, -1 is JSON. Nothing for another number.
std::optional<RcgVersion> rcg_version(int game_log_version);

/// Decides which records a log gets (simulation-model 12.4, log-formats 1.4 to 1.10) and writes
/// them into `sink`, which must outlive the writer. The bytes depend on nothing but the arguments.
class RcgWriter {
 public:
  explicit RcgWriter(base::ByteSink& sink, RcgVersion version = RcgVersion::kV6, LogDate date = {});

  /// Once, before anything else.
  void begin(const soccer::ServerParams& server, const soccer::PlayerParams& player,
             const std::vector<soccer::PlayerType>& types);

  /// Once per simulation step, in every play mode. Nothing is written before kick-off, and after
  /// time over only the first frame; records of play mode and teams are added where they changed.
  void step(const Frame& frame);

  /// A message at the place in the log that is reached.
  void message(Stamp stamp, int board, std::string_view text);

  /// Once, after everything else: the result.
  void end(const Frame& last);

 private:
  bool is_binary() const { return version_ <= RcgVersion::kV3; }
  void add_play_mode(const Frame& frame);
  void add_teams(const Frame& frame);
  void add_show(const Frame& frame);
  void write();

  base::ByteSink& sink_;
  RcgVersion version_;
  LogDate date_;
  std::string line_;
  soccer::PlayMode written_mode_ = soccer::PlayMode::kNull;
  bool team_written_ = false;
  TeamFrames written_teams_;
};

}  // namespace cls::gamelog
