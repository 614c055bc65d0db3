// Plain values as text, and back: what the command line, cls.toml and `cls config` show and read.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace cls::base {

/// The value of all of `text`; nothing if it is not a decimal number, or one that the type cannot
/// hold. A bool is "true" or anything else; texts and paths are taken as they are.
template <class Value>
std::optional<Value> value_of(std::string_view text) {
  if constexpr (std::is_same_v<Value, bool>) {
    return text == "true";
  } else if constexpr (std::is_arithmetic_v<Value>) {
    Value value{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    if constexpr (std::is_floating_point_v<Value>) {
      if (!std::isfinite(value)) return std::nullopt;
    }
    return value;
  } else {
    return Value(text);
  }
}

template <class Value>
std::string text_of(const Value& value) {
  if constexpr (std::is_same_v<Value, std::filesystem::path>) {
    return value.string();
  } else {
    return fmt::format("{}", value);
  }
}

/// Empty for nothing.
template <class Value>
std::string text_of(const std::optional<Value>& value) {
  return value ? text_of(*value) : std::string();
}

}  // namespace cls::base
