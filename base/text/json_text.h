// JSON as text. Bytes that are not UTF-8 become U+FFFD: names and paths may have any. Characters
// that would act on a terminal are escaped.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/text/printable.h"

namespace cls::base {

/// One line, without a line feed.
template <typename Json>
std::string json_line(const Json& json) {
  return printable_json(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// Indented by two spaces, with a line feed at the end.
template <typename Json>
std::string json_document(const Json& json) {
  return printable_json(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace cls::base
