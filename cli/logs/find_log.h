// The log that a user means: a file, or one in a match folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/result.h"
#include "gamelog/files/log_files.h"
#include "gamelog/rcl/rcl_record.h"

namespace cls::cli {

struct FoundLog {
  gamelog::MatchLogs logs;
  std::filesystem::path folder;  ///< where files about the match go by default
  std::string name;              ///< of those files, without suffix: "match", "game"
};

/// `what` is a game log, a page, a folder that find_match_folder() knows, or "-" for standard
/// input.
base::Result<FoundLog> find_log(const std::string& what);

/// The text log of a match; nothing if there is none, or it cannot be read.
std::optional<gamelog::RclRecord> read_text_log(const FoundLog& found);

/// Why a page cannot be written to `file`: pages are replaced, other files are not.
std::optional<std::string> why_no_page(const std::filesystem::path& file);

/// Writes `text` to `file`. The error names --out if that did not choose the file: the folder of a
/// match may be read-only.
base::Result<void> write_beside(const std::filesystem::path& file, const std::string& text,
                                const std::string& out_option);

}  // namespace cls::cli
