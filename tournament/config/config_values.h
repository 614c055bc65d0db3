// Types of the values of keys: what they accept, and how they are written.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/result.h"

namespace cls::tournament {

using Texts = std::vector<std::string>;

/// A value in a file or on the command line.
using ConfigValue = std::variant<bool, std::int64_t, double, std::string, Texts, std::vector<Texts>,
                                 std::vector<std::int64_t>>;

/// The value that a text on the command line stands for; a text that is none is a string.
using ReadText = ConfigValue (*)(std::string_view text);
ConfigValue read_flag(std::string_view text);
ConfigValue read_whole(std::string_view text);
ConfigValue read_number(std::string_view text);
ConfigValue read_text(std::string_view text);
ConfigValue read_list(std::string_view text);         ///< A,B,C
ConfigValue read_pairings(std::string_view text);     ///< A:B,C:D
ConfigValue read_shell_words(std::string_view text);  ///< --a=b '--c=d e'

std::optional<double> number_in(const ConfigValue& value);

template <class Value>
struct ValueType {
  ReadText read;
  /// The error names the accepted values ("must be a whole number from 1").
  std::function<base::Result<Value>(const ConfigValue&)> parse;
  /// As TOML; empty: not set.
  std::function<std::string(const Value&)> format;
};

ValueType<int> whole(std::int64_t min, std::int64_t max);
ValueType<double> positive(std::string unit);
ValueType<bool> flag();
ValueType<std::string> text();

/// Strings for which `element_error` is empty; `error`: of another value.
ValueType<Texts> texts(std::string error,
                       std::function<std::string(const std::string&)> element_error = {});
/// The same; one string is a list, too.
ValueType<Texts> text_or_texts(std::string error);

template <class Value>
ValueType<std::optional<Value>> optional(ValueType<Value> type) {
  return {type.read,
          [type](const ConfigValue& value) -> base::Result<std::optional<Value>> {
            TRY_INIT(Value read, type.parse(value));
            return std::optional<Value>(std::move(read));
          },
          [type](const std::optional<Value>& value) {
            return value ? type.format(*value) : std::string();
          }};
}

/// "'stpo': did you mean 'stop'?"
std::string unknown_value(std::string_view value, const std::vector<std::string_view>& names);

/// The position of a value among `names`.
base::Result<std::size_t> position_of(const ConfigValue& value,
                                      const std::vector<std::string_view>& names);

/// A string as a TOML basic string, quotes included.
std::string toml_quoted(std::string_view text);
std::string toml_list(const Texts& texts);
std::string toml_list(const std::vector<Texts>& lists);

/// The enumerators 0, 1, ... have these names.
template <class Enum>
ValueType<Enum> choice(std::vector<std::string_view> names) {
  return {read_text,
          [names](const ConfigValue& value) -> base::Result<Enum> {
            TRY_INIT(const std::size_t position, position_of(value, names));
            return static_cast<Enum>(position);
          },
          [names](Enum value) { return toml_quoted(names[static_cast<std::size_t>(value)]); }};
}

template <class Names>
std::vector<std::string_view> list_of(const Names& names) {
  return {names.texts.begin(), names.texts.end()};
}

}  // namespace cls::tournament
