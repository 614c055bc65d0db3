// JSON as text. Bytes that are not UTF-8 become U+FFFD: names and paths may have any. Characters
// that would act on a terminal are escaped.
#pragma once

#include <string>

#include "base/text/json.h"
#include "base/text/printable.h"

namespace cls::base {

/// One line, without a line feed.
inline std::string json_line(const Json& json) { return printable_json(json.dump()); }

/// Indented by two spaces, with a line feed at the end.
inline std::string json_document(const Json& json) { return printable_json(json.dump(2)) + "\n"; }

}  // namespace cls::base
