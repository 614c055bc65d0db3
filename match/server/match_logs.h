// The game log and text log of a match folder.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/io/byte_sink.h"
#include "base/result.h"
#include "match/result/match_result.h"
#include "match/terms/match_options.h"
#include "soccer/parameters/server_params.h"

namespace cls::match {

/// The logs of a match in lockstep: which (server::game_logging, text_logging) and how compressed
/// (server::game_log_compression, text_log_compression: 0 plain, 1 to 9 match.rcg.gz and so on,
/// by threads of their own).
class MatchLogs {
 public:
  /// The error names the file that cannot be created.
  /// `keep_space`: for a match beside programs that may fill the disk.
  static base::Result<MatchLogs> create(const std::filesystem::path& folder,
                                        const soccer::ServerParams& params, bool keep_space);

  base::ByteSink* game() { return game_.get(); }  ///< nullptr: not wanted
  base::ByteSink* text() { return text_.get(); }

  /// Closes them, names them in the result, and returns the first error since the start.
  base::Result<void> close(MatchResult& result);

 private:
  std::unique_ptr<base::ByteSink> game_;
  std::unique_ptr<base::ByteSink> text_;
  std::string game_name_;
  std::string text_name_;
  std::vector<std::filesystem::path> kept_;  ///< files with space for more
};

/// The file of the game log while the match is played; empty: none is wanted. An external server
/// writes it plain.
std::string running_game_log(const MatchOptions& options);

/// Turns the logs of an external server, which writes them plain and in version 6, into those that
/// the parameters ask for, once the match is over. Names them in the result.
base::Result<void> convert_server_logs(const std::filesystem::path& folder,
                                       const soccer::ServerParams& params, MatchResult& result);

}  // namespace cls::match
