// Files with a JSON document in each line.
#pragma once

#include <exception>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/catch_as_error.h"
#include "base/result.h"
#include "tournament/store/folder.h"

namespace cls::tournament {

/// What `parse` makes of each line of a file of JSON; nothing without the file. The error names the
/// line in which `parse` threw.
template <typename Parse>
auto read_json_lines(const std::filesystem::path& file, Parse parse)
    -> base::Result<std::vector<decltype(parse(std::string()))>> {
  std::vector<decltype(parse(std::string()))> values;
  TRY_INIT(const std::string text, read_if_there(file));
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::string place = file.string() + ":" + std::to_string(number);
    TRY_INIT(auto value, base::catch_as_error<std::exception>(place, [&] { return parse(line); }));
    values.push_back(std::move(value));
  }
  return values;
}

}  // namespace cls::tournament
