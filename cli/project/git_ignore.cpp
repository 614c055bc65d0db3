// Matches patterns with fnmatch().
#include "cli/project/git_ignore.h"

#include <fnmatch.h>

#include <algorithm>
#include <utility>

#include "base/io/whole_file.h"
#include "base/text/split.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kIgnoreFile = ".gitignore";

bool matches_glob(const std::string& pattern, const std::string& path) {
  return ::fnmatch(pattern.c_str(), path.c_str(), FNM_PATHNAME) == 0;
}

// "**" stands for any folders, also none: each of its places is tried.
bool matches_path(const std::string& pattern, const std::string& path) {
  const std::size_t stars = pattern.find("**");
  if (stars == std::string::npos) return matches_glob(pattern, path);

  const std::string before = pattern.substr(0, stars);
  std::string after = pattern.substr(stars + 2);
  if (after.empty())
    return matches_glob(before + "*", path.substr(0, path.find('/', before.size())));
  if (after.starts_with('/')) after.erase(0, 1);
  if (matches_path(before + after, path)) return true;

  for (std::size_t slash = path.find('/'); slash != path.npos; slash = path.find('/', slash + 1)) {
    const std::string folders = path.substr(0, slash + 1);
    const bool begins = before.empty() || matches_glob(before + "*", folders.substr(0, slash)) ||
                        folders.starts_with(before);
    if (begins && matches_path(after, path.substr(slash + 1))) return true;
  }
  return false;
}

}  // namespace

void GitIgnore::read(const fs::path& folder) {
  const fs::path file = folder / kIgnoreFile;
  if (base::why_no_file(file)) return;
  const std::string text = base::read_text(file).value_or("");
  for (const std::string_view line : base::split(text, '\n')) add(line, folder);
}

void GitIgnore::add(std::string_view line, const fs::path& folder) {
  const std::size_t last = line.find_last_not_of(" \t\r");
  line = line.substr(0, last == line.npos ? 0 : last + 1);
  if (line.starts_with('#')) return;

  Pattern pattern;
  pattern.folder = folder;
  pattern.included = line.starts_with('!');
  if (pattern.included) line.remove_prefix(1);
  pattern.of_folders = line.ends_with('/');
  if (pattern.of_folders) line.remove_suffix(1);
  pattern.anchored = line.find('/') != line.npos;
  if (line.starts_with('/')) line.remove_prefix(1);
  if (line.empty()) return;

  pattern.text = line;
  patterns_.push_back(std::move(pattern));
}

bool GitIgnore::ignores(const fs::path& path, bool is_folder) const {
  bool ignored = false;
  for (const Pattern& pattern : patterns_) {
    if (pattern.of_folders && !is_folder) continue;
    const std::string below = path.lexically_relative(pattern.folder).generic_string();
    if (below.starts_with("..")) continue;
    const std::string name = path.filename().string();
    if (matches_path(pattern.text, pattern.anchored ? below : name)) ignored = !pattern.included;
  }
  return ignored;
}

}  // namespace cls::cli
