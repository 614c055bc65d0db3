// Lists the files of the project.
#include "tests/architecture/source_files.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "tests/support/command.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;

/// Relative to `root`; nothing where git does not track the folder.
std::vector<std::string> tracked_names(const fs::path& root) {
  const CommandResult listed = run({"git", "-C", root, "ls-files", "-z"});
  std::vector<std::string> all;
  if (listed.exit_code != 0) return all;
  std::istringstream names(listed.out);
  for (std::string name; std::getline(names, name, '\0');) all.push_back(name);
  return all;
}

std::vector<fs::path> tracked_files(const fs::path& root) {
  std::vector<fs::path> files;
  for (const std::string& name : tracked_names(root)) {
    const bool hidden = name.starts_with('.') || name.find("/.") != std::string::npos;
    if (!hidden && fs::is_regular_file(root / name)) files.push_back(root / name);
  }
  return files;
}

bool holds_sources(const fs::path& folder, const fs::path& root) {
  const std::string name = folder.filename().string();
  const bool top = folder.parent_path() == root;
  if (top && (name.starts_with("build") || name == "runs")) return false;
  return name.front() != '.' && name != "node_modules" && name != "__pycache__";
}

std::vector<fs::path> found_files(const fs::path& root) {
  std::vector<fs::path> files;
  std::vector<fs::path> folders = {root};
  while (!folders.empty()) {
    const fs::path folder = std::move(folders.back());
    folders.pop_back();
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.is_regular_file()) files.push_back(entry.path());
      if (entry.is_directory() && holds_sources(entry.path(), root)) {
        folders.push_back(entry.path());
      }
    }
  }
  return files;
}

}  // namespace

std::vector<fs::path> links_of_project(const fs::path& root) {
  std::vector<fs::path> links;
  for (const std::string& name : tracked_names(root)) {
    if (fs::is_symlink(root / name)) links.push_back(root / name);
  }
  return links;
}

std::vector<fs::path> files_of_project(const fs::path& root) {
  std::vector<fs::path> files = tracked_files(root);
  if (files.empty()) files = found_files(root);
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> source_files() { return files_of_project(source_folder()); }

}  // namespace cls::tests
