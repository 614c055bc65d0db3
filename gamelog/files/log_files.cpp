// Finds logs in folders and by patterns.
#include "gamelog/files/log_files.h"

#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>

#include "base/io/whole_file.h"

namespace cls::gamelog {
namespace {

namespace fs = std::filesystem;

bool has_ending(std::string_view path, std::string_view ending) {
  if (path.ends_with(".gz")) path.remove_suffix(3);
  return path.ends_with(ending);
}

bool is_text_log(std::string_view path) { return has_ending(path, ".rcl"); }
bool is_game_log(std::string_view path) { return has_ending(path, ".rcg"); }

// The path without .rcg, .rcl and .gz: equal for the two logs of a match.
std::string stem_of(std::string path) {
  if (path.ends_with(".gz")) path.resize(path.size() - 3);
  if (is_text_log(path) || is_game_log(path)) path.resize(path.size() - 4);
  return path;
}

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

std::vector<std::string> logs_below(const std::string& folder) {
  std::vector<std::string> found;
  std::error_code error;
  std::error_code ignored;
  const auto options = fs::directory_options::skip_permission_denied;

  for (fs::recursive_directory_iterator at(folder, options, error), end; !error && at != end;
       at.increment(error)) {
    const std::string path = at->path().string();
    if (at->is_directory(ignored) && fs::exists(at->path() / kApartMark, ignored)) {
      at.disable_recursion_pending();
    }
    if (!is_text_log(path) && !is_game_log(path)) continue;

    // Reading a pipe of that name would wait for a writer.
    if (at->is_regular_file(ignored)) found.push_back(path);
  }

  std::ranges::sort(found);
  return found;
}

std::vector<std::string> matches_of(const std::string& pattern) {
  std::vector<std::string> found;
  glob_t result = {};
  if (::glob(pattern.c_str(), 0, nullptr, &result) == 0) {
    found.assign(result.gl_pathv, result.gl_pathv + result.gl_pathc);
  }

  ::globfree(&result);
  return found;
}

// The log files that one argument refers to.
std::vector<std::string> files_of(const std::string& argument) {
  if (argument == "-") return {argument};

  std::error_code ignored;
  if (fs::is_directory(argument, ignored)) return logs_below(argument);
  if (exists(argument)) return {argument};

  std::vector<std::string> files;
  for (const std::string& match : matches_of(argument)) {
    if (!fs::is_directory(match, ignored)) {
      files.push_back(match);
      continue;
    }

    const std::vector<std::string> below = logs_below(match);
    files.insert(files.end(), below.begin(), below.end());
  }

  return files;
}

void find_text_log(const std::string& stem, MatchLogs& logs) {
  if (!logs.text.empty() || logs.game == "-") return;
  for (const char* ending : {".rcl", ".rcl.gz"}) {
    std::error_code ignored;
    if (fs::is_regular_file(stem + ending, ignored)) {
      logs.text = stem + ending;
      return;
    }
  }
}

}  // namespace

base::Result<void> set_apart(const fs::path& folder) {
  TRY(base::create_folders(folder));
  std::error_code ignored;
  if (fs::exists(folder / kApartMark, ignored)) return {};
  return base::write_file(folder / kApartMark,
                          "The logs here are not results: cls results, stats and book pass by.\n");
}

FoundLogs find_logs(const std::vector<std::string>& arguments) {
  FoundLogs found;
  std::map<std::string, std::size_t> by_stem;
  std::vector<std::string> stems;

  for (const std::string& argument : arguments) {
    const std::vector<std::string> files = files_of(argument);
    if (files.empty()) found.missing.push_back(argument);

    for (const std::string& file : files) {
      const auto [known, added] = by_stem.emplace(stem_of(file), found.matches.size());
      if (added) {
        found.matches.emplace_back();
        stems.push_back(known->first);
      }

      MatchLogs& logs = found.matches[known->second];
      std::string& path = is_text_log(file) ? logs.text : logs.game;
      if (path.empty()) path = file;
    }
  }

  for (std::size_t i = 0; i < stems.size(); ++i) find_text_log(stems[i], found.matches[i]);

  return found;
}

}  // namespace cls::gamelog
