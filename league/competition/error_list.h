// Errors of a configuration, one line each.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cls::league {

class ErrorList {
 public:
  void require(bool condition, std::string message) {
    if (!condition) lines_.push_back(std::move(message));
  }
  void add(std::vector<std::string> lines) {
    for (std::string& line : lines) lines_.push_back(std::move(line));
  }
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  std::vector<std::string> lines_;
};

}  // namespace cls::league
