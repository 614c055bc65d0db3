// Splits schemas at the slash.
#include "base/text/schema.h"

#include <fmt/format.h>

#include <utility>

#include "base/text/value_text.h"

namespace cls::base {
namespace {

// {"cls.match", 1}; the version is 0 if it is not a number.
std::pair<std::string_view, int> name_and_version(std::string_view schema) {
  const std::size_t slash = schema.find('/');
  if (slash == std::string_view::npos) return {schema, 0};

  return {schema.substr(0, slash), value_of<int>(schema.substr(slash + 1)).value_or(0)};
}

}  // namespace

std::optional<std::string> schema_error(std::string_view schema, std::string_view newest) {
  const auto [name, version] = name_and_version(schema);
  const auto [known_name, known_version] = name_and_version(newest);
  if (name != known_name || version < 1) {
    return fmt::format("schema '{}' is not {}", schema, newest);
  }
  if (version <= known_version) return std::nullopt;
  return fmt::format("schema {} is newer than this cls reads ({}); update cls", schema, newest);
}

std::optional<std::string> schema_error(std::int64_t version, int newest) {
  if (version < 1) return fmt::format("schema: must be a whole number from 1 to {}", newest);
  if (version <= newest) return std::nullopt;
  return fmt::format("schema {} is newer than this cls reads ({}); update cls", version, newest);
}

}  // namespace cls::base
