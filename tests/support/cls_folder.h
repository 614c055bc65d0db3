// A temporary folder in which tests run cls.
#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {

/// A base of test fixtures: an empty folder, which is the working folder of cls.
class ClsFolder {
 public:
  /// Runs of cls that take longer than `limit` are killed (exit_code -1).
  explicit ClsFolder(std::chrono::seconds limit = std::chrono::seconds(60)) : limit_(limit) {}

  /// Runs cls with `arguments` in the folder to its end.
  CommandResult run(std::vector<std::string> arguments,
                    std::vector<std::string> environment = {}) const {
    arguments.insert(arguments.begin(), cls_binary());
    return Command(std::move(arguments), std::move(environment), folder_.path()).finish(limit_);
  }
  std::filesystem::path path(const std::filesystem::path& name) const {
    return folder_.path() / name;
  }
  /// Writes a file of the folder and creates the folders above it.
  void write(const std::filesystem::path& name, const std::string& text) const {
    std::filesystem::create_directories(path(name).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
  }

 protected:
  TemporaryFolder folder_;

 private:
  std::chrono::seconds limit_;
};

}  // namespace cls::tests
