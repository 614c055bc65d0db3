// Programs in a package: their loader and libraries beside them, and scripts that start them so.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/result.h"

namespace cls::cli {

/// lib/ of a package: one loader and the libraries of all its programs, of the host that made it.
class Bundle {
 public:
  /// `loader` is that of all programs. Errors name the file.
  static base::Result<Bundle> create(const std::filesystem::path& package,
                                     const std::filesystem::path& loader);

  /// Copies the libraries that a program or library needs; those inside of the package stay where
  /// they are. An error if two programs need different libraries of one name, or another loader.
  base::Result<void> add_libraries(const std::filesystem::path& file);

  /// Copies a program to `target` in the package and makes `script` there, which starts it.
  /// `settings` are lines of the script before that; $here in them is the package.
  base::Result<void> add_program(const std::filesystem::path& program,
                                 const std::filesystem::path& target,
                                 const std::filesystem::path& script,
                                 const std::string& settings = {});

  /// Of all files below `folder` of the package: programs that need newer systems get a script
  /// under their name, if they have none, and all files their libraries.
  base::Result<void> add_folder(const std::filesystem::path& folder);

  /// Libraries that this host does not have: "numpy/core/x.so: libfoo.so.1".
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  base::Result<void> write_script(const std::filesystem::path& target,
                                  const std::filesystem::path& script, const std::string& settings);
  base::Result<void> add_library(const std::string& name, const std::filesystem::path& path,
                                 const std::filesystem::path& file);

  std::filesystem::path package_;
  std::filesystem::path loader_;
  std::map<std::string, std::filesystem::path> libraries_;  ///< by name: the copied one
  std::set<std::filesystem::path> programs_;                ///< that have a script
  std::vector<std::string> missing_;
};

/// The loader of a program of this host, "/lib64/ld-linux-x86-64.so.2"; empty: it needs none.
std::filesystem::path loader_of(const std::filesystem::path& program);

}  // namespace cls::cli
