// Finds logs in folders and by patterns.
#include "gamelog/files/log_files.h"

#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/io/byte_source.h"
#include "base/io/input_buffer.h"
#include "base/io/whole_file.h"

namespace cls::gamelog {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPackedEndings[] = {"", ".gz", ".xz", ".zst"};

bool is_game_log(std::string_view path) { return unpacked_name(path).ends_with(".rcg"); }

// The path without .rcg, .rcl and .gz: equal for the two logs of a match.
std::string stem_of(std::string_view path) {
  std::string_view stem = unpacked_name(path);
  if (is_text_log(path) || is_game_log(path)) stem.remove_suffix(4);
  return std::string(stem);
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

// True for a log and its compressed copy.
bool has_same_text(const std::string& one, const std::string& other) {
  std::error_code ignored;
  if (one == other || fs::equivalent(one, other, ignored)) return true;
  const auto first = base::open_source(one);
  const auto second = base::open_source(other);
  if (!first || !second) return false;

  constexpr std::size_t kBlock = 64 * 1024;
  base::InputBuffer a(**first);
  base::InputBuffer b(**second);
  for (;;) {
    const std::string_view block = a.take(kBlock);
    if (block != b.take(kBlock)) return false;
    if (block.empty()) return true;
  }
}

void find_text_log(const std::string& stem, MatchLogs& logs) {
  if (stem.empty() || !logs.text.empty() || logs.game == "-") return;
  for (const std::string_view ending : kPackedEndings) {
    std::error_code ignored;
    const std::string file = stem + ".rcl" + std::string(ending);
    if (fs::is_regular_file(file, ignored)) {
      logs.text = file;
      return;
    }
  }
}

}  // namespace

std::string_view unpacked_name(std::string_view path) {
  for (const std::string_view ending : kPackedEndings) {
    if (!ending.empty() && path.ends_with(ending)) {
      return path.substr(0, path.size() - ending.size());
    }
  }
  return path;
}

bool is_text_log(std::string_view path) { return unpacked_name(path).ends_with(".rcl"); }

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
      if (path.empty()) {
        path = file;
      } else if (!has_same_text(path, file)) {
        MatchLogs& other = found.matches.emplace_back();  // another match of the same name
        (is_text_log(file) ? other.text : other.game) = file;
        stems.emplace_back();
      }
    }
  }

  for (std::size_t i = 0; i < stems.size(); ++i) find_text_log(stems[i], found.matches[i]);

  return found;
}

}  // namespace cls::gamelog
