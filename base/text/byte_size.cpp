// Parses and formats sizes.
#include "base/text/byte_size.h"

#include <fmt/format.h>

#include <cstddef>
#include <limits>

#include "base/text/value_text.h"

namespace cls::base {
namespace {

constexpr std::string_view kUnits = "KMGT";
constexpr unsigned kBitsPerUnit = 10;

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

}  // namespace

std::optional<std::uint64_t> parse_byte_size(std::string_view text) {
  if (text.empty()) return std::nullopt;
  const std::size_t unit = kUnits.find(upper(text.back()));
  if (unit == std::string_view::npos) return std::nullopt;
  text.remove_suffix(1);

  const auto number = value_of<std::uint64_t>(text);
  const unsigned shift = kBitsPerUnit * static_cast<unsigned>(unit + 1);
  if (!number || *number == 0) return std::nullopt;
  if (*number > std::numeric_limits<std::uint64_t>::max() >> shift) return std::nullopt;
  return *number << shift;
}

std::string byte_size_text(std::uint64_t bytes) {
  std::uint64_t number = bytes >> kBitsPerUnit;
  std::size_t unit = 0;
  while (unit + 1 < kUnits.size() && number != 0 && number % (1U << kBitsPerUnit) == 0) {
    number >>= kBitsPerUnit;
    ++unit;
  }
  return fmt::format("{}{}", number, kUnits[unit]);
}

}  // namespace cls::base
