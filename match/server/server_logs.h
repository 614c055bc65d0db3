// Log files of `cls server`, with the names of rcssserver.
#pragma once

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/io/byte_sink.h"
#include "base/result.h"
#include "gamelog/record/frame.h"
#include "simulator/sessions/match_recorder.h"
#include "soccer/parameters/server_params.h"

namespace cls::match {

/// Enough for each log of a whole match.
inline constexpr std::uint64_t kSpaceOfLog = std::uint64_t{16} << 20;

/// The date of a match that begins then, in local time.
gamelog::LogDate log_date(std::time_t start);

/// Opens the logs that the parameters ask for (game_logging, text_logging; keepaway_logging in
/// keepaway): game_log_dir, game_log_fixed_name, game_log_dated, game_log_compression and so on.
/// During the match they are named incomplete.rcg, .rcl and .kwy; finish() renames them
/// (`20261120203857-A_1-vs-B_0.rcg`) unless names are fixed. A game log with the date in its name
/// has it in its contents too, so only logs with other names can be identical.
class ServerLogs {
 public:
  /// The error names the file or folder that cannot be created. game_log_version must be one (see
  /// gamelog::rcg_version).
  /// `keep_space`: for a match beside programs that may fill the disk.
  static base::Result<ServerLogs> open(const soccer::ServerParams& params, std::time_t start,
                                       bool keep_space = false);

  /// nullptr: no such log.
  simulator::LogSinks sinks() const;
  base::ByteSink* keepaway() { return keepaway_.sink.get(); }

  /// Closes and renames them. Returns the first error since the start.
  base::Result<void> finish(const gamelog::TeamFrames& teams);

  /// Their paths; final after finish().
  std::vector<std::filesystem::path> paths() const;

 private:
  struct Log {
    std::unique_ptr<base::ByteSink> sink;
    std::filesystem::path path;
    std::string ending;
    std::string date;    ///< before the name of the match
    bool fixed = false;  ///< keeps its name
  };
  struct Wish;

  static base::Result<Log> open(const Wish& wish, const std::string& date);
  base::Result<void> finish(Log& log, const std::string& match) const;

  Log game_;
  Log text_;
  Log keepaway_;
  gamelog::RcgVersion version_ = gamelog::RcgVersion::kV6;
  gamelog::LogDate date_;
  bool keeps_space_ = false;
};

}  // namespace cls::match
