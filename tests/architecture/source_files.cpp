// Walks the source folder.
#include "tests/architecture/source_files.h"

#include <algorithm>
#include <string>

#include "tests/support/files.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;

bool holds_sources(const fs::path& folder) {
  const std::string name = folder.filename().string();
  const bool top = folder.parent_path() == source_folder();
  if (top && (name.starts_with("build") || name == "runs")) return false;
  return name.front() != '.' && name != "node_modules" && name != "__pycache__";
}

}  // namespace

std::vector<fs::path> source_files() {
  std::vector<fs::path> files;
  std::vector<fs::path> folders = {source_folder()};
  while (!folders.empty()) {
    const fs::path folder = std::move(folders.back());
    folders.pop_back();
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.is_regular_file()) files.push_back(entry.path());
      if (entry.is_directory() && holds_sources(entry.path())) folders.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace cls::tests
