// Splits schemas at the slash.
#include "base/text/schema.h"

#include <fmt/format.h>

#include <charconv>
#include <utility>

namespace cls::base {
namespace {

// {"cls.match", 1}; the version is 0 if it is not a number.
std::pair<std::string_view, int> name_and_version(std::string_view schema) {
  const std::size_t slash = schema.find('/');
  if (slash == std::string_view::npos) return {schema, 0};

  const std::string_view digits = schema.substr(slash + 1);
  int version = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), version);
  if (error != std::errc() || end != digits.data() + digits.size()) version = 0;
  return {schema.substr(0, slash), version};
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
