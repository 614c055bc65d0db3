// Compares times and sizes of files.
#include "cli/match/file_watch.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "base/io/whole_file.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

// Names, and paths from the folder, that are not watched. Of .gitignore the plain lines count.
std::set<std::string> ignored_names(const fs::path& folder) {
  std::set<std::string> names = {"node_modules", "__pycache__", "target", "runs", "match"};
  std::istringstream lines{base::read_file(folder / ".gitignore").value_or("")};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of("/ ");
    const std::size_t end = line.find_last_not_of("/ ");
    const bool plain = begin != std::string::npos && line[begin] != '#' && line[begin] != '!' &&
                       line.find_first_of("*?[") == std::string::npos;
    if (plain) names.insert(line.substr(begin, end - begin + 1));
  }
  return names;
}

// True for the file that this process prints into: `cls dev >FILE` would see its own output.
bool is_own_output(const fs::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) return false;

  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat output {};
    if (::fstat(stream, &output) == 0 && output.st_dev == found.st_dev &&
        output.st_ino == found.st_ino) {
      return true;
    }
  }
  return false;
}

}  // namespace

FileVersions file_versions(const fs::path& folder) {
  FileVersions files;
  const std::set<std::string> ignored = ignored_names(folder);
  std::error_code code;
  fs::recursive_directory_iterator entry(folder, code);
  for (; !code && entry != fs::recursive_directory_iterator(); entry.increment(code)) {
    const std::string name = entry->path().filename().string();
    const std::string path = entry->path().lexically_relative(folder).string();

    std::error_code failed;
    if (name.starts_with(".") || ignored.contains(name) || ignored.contains(path)) {
      if (entry->is_directory(failed)) entry.disable_recursion_pending();
      continue;
    }

    if (!entry->is_regular_file(failed) || is_own_output(entry->path())) continue;
    const auto time = entry->last_write_time(failed);
    const auto size = entry->file_size(failed);
    if (!failed) files.emplace(path, std::pair(time, size));
  }
  return files;
}

std::vector<std::string> changed_files(const FileVersions& before, const FileVersions& now) {
  std::vector<std::string> changed;
  for (const auto& [path, version] : now) {
    const auto found = before.find(path);
    if (found == before.end() || found->second != version) changed.push_back(path);
  }
  for (const auto& [path, version] : before) {
    if (!now.contains(path)) changed.push_back(path);
  }
  std::ranges::sort(changed);
  return changed;
}

}  // namespace cls::cli
