// Looks for files by name.
#include "match/result/match_files.h"

#include "match/result/match_folder.h"

namespace cls::match {

namespace {

namespace fs = std::filesystem;

}  // namespace

fs::path game_log_in(const fs::path& folder) {
  fs::path log = folder / kGameLogFile;
  std::error_code code;

  if (fs::exists(log, code)) return log;
  fs::path packed = log.string() + ".gz";
  return fs::exists(packed, code) ? packed : log;
}

bool has_result(const fs::path& folder) {
  std::error_code code;
  return fs::exists(folder / kResultFile, code);
}

}  // namespace cls::match
