// The files that .gitignore of a project names.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cls::cli {

/// The patterns of the .gitignore files of a folder tree, as git reads them. Needs no repository.
class GitIgnore {
 public:
  /// Reads the .gitignore of `folder`, which may be missing. Folders come before their sub-folders.
  void read(const std::filesystem::path& folder);

  /// True if the last pattern that matches `path` ignores it. Its folders are not looked at: who
  /// walks a tree does not enter ignored ones.
  bool ignores(const std::filesystem::path& path, bool is_folder) const;

 private:
  struct Pattern {
    std::filesystem::path folder;  ///< of its .gitignore
    std::string text;              ///< without "!" and slashes at its ends
    bool included = false;         ///< "!": what an earlier pattern ignores comes back
    bool of_folders = false;       ///< "runs/"
    bool anchored = false;         ///< "/pb", "src/wire": from `folder` on
  };

  void add(std::string_view line, const std::filesystem::path& folder);

  std::vector<Pattern> patterns_;
};

}  // namespace cls::cli
