// Parsers and formatters of values.
#include "tournament/config/config_values.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/split.h"
#include "base/text/suggestion.h"
#include "base/text/value_text.h"

namespace cls::tournament {
namespace {

using base::Error;
using base::Result;

template <class Value>
ConfigValue value_or_text(std::string_view text) {
  if (const auto value = base::value_of<Value>(text)) return *value;
  return std::string(text);
}

Texts split(std::string_view text, char at) {
  const auto parts = base::split(text, at);
  return {parts.begin(), parts.end()};
}

// The words of a shell, which quotes and backslashes may hold together; nothing if a quote is open.
std::optional<Texts> shell_words(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\n";
  Texts words;
  char quote = 0;
  bool in_word = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote == 0 && kBlanks.find(c) != kBlanks.npos) {
      in_word = false;
      continue;
    }
    if (!std::exchange(in_word, true)) words.emplace_back();

    if (quote != 0 ? c == quote : c == '\'' || c == '"') {
      quote = quote == 0 ? c : 0;
    } else if (c == '\\' && quote != '\'' && i + 1 < text.size()) {
      words.back() += text[++i];
    } else {
      words.back() += c;
    }
  }
  return quote == 0 ? std::optional(std::move(words)) : std::nullopt;
}

template <class Value>
Result<Value> exactly(const ConfigValue& value, const char* error) {
  if (const auto* read = std::get_if<Value>(&value)) return *read;
  return Error{error};
}

}  // namespace

ConfigValue read_flag(std::string_view text) {
  if (text == "true" || text == "false") return text == "true";
  return std::string(text);
}

ConfigValue read_whole(std::string_view text) { return value_or_text<std::int64_t>(text); }

ConfigValue read_number(std::string_view text) { return value_or_text<double>(text); }

ConfigValue read_text(std::string_view text) { return std::string(text); }

ConfigValue read_list(std::string_view text) { return split(text, ','); }

ConfigValue read_pairings(std::string_view text) {
  std::vector<Texts> pairings;
  for (const std::string& one : split(text, ',')) pairings.push_back(split(one, ':'));
  return pairings;
}

ConfigValue read_shell_words(std::string_view text) {
  if (auto words = shell_words(text)) return *std::move(words);
  return std::string(text);
}

std::optional<double> number_in(const ConfigValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&value)) return *real;
  return std::nullopt;
}

ValueType<int> whole(std::int64_t min, std::int64_t max) {
  return {read_whole,
          [=](const ConfigValue& value) -> Result<int> {
            const auto* read = std::get_if<std::int64_t>(&value);
            if (read == nullptr || *read < min || *read > max) {
              return Error{fmt::format("must be a whole number from {} to {}", min, max)};
            }
            return static_cast<int>(*read);
          },
          [](int value) { return fmt::to_string(value); }};
}

ValueType<double> positive(std::string unit) {
  return {read_number,
          [unit = std::move(unit)](const ConfigValue& value) -> Result<double> {
            const auto read = number_in(value);
            if (!read || *read <= 0) {
              return Error{fmt::format("must be a positive number of {}", unit)};
            }
            return *read;
          },
          [](double value) { return fmt::format("{}", value); }};
}

ValueType<bool> flag() {
  return {read_flag,
          [](const ConfigValue& value) { return exactly<bool>(value, "must be true or false"); },
          [](bool value) { return std::string(value ? "true" : "false"); }};
}

ValueType<std::string> text() {
  return {read_text,
          [](const ConfigValue& value) { return exactly<std::string>(value, "must be a string"); },
          [](const std::string& value) { return value.empty() ? value : toml_quoted(value); }};
}

ValueType<Texts> texts(std::string error,
                       std::function<std::string(const std::string&)> element_error) {
  return {read_list,
          [=](const ConfigValue& value) -> Result<Texts> {
            TRY_INIT(Texts list, exactly<Texts>(value, error.c_str()));
            for (const std::string& element : list) {
              std::string wrong = element_error ? element_error(element) : std::string();
              if (!wrong.empty()) return Error{std::move(wrong)};
            }
            return list;
          },
          [](const Texts& list) { return list.empty() ? std::string() : toml_list(list); }};
}

ValueType<Texts> text_or_texts(std::string error) {
  ValueType<Texts> type = texts(std::move(error));
  type.parse = [several = type.parse](const ConfigValue& value) -> Result<Texts> {
    if (const auto* one = std::get_if<std::string>(&value)) return Texts{*one};
    return several(value);
  };
  return type;
}

std::string unknown_value(std::string_view value, const std::vector<std::string_view>& names) {
  const std::string_view near = base::nearest_name(value, names);
  if (!near.empty()) return fmt::format("'{}': did you mean '{}'?", value, near);
  return fmt::format("'{}' is not one of {}", value, fmt::join(names, ", "));
}

Result<std::size_t> position_of(const ConfigValue& value,
                                const std::vector<std::string_view>& names) {
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) return Error{fmt::format("must be one of {}", fmt::join(names, ", "))};
  const auto found = std::ranges::find(names, *text);
  if (found == names.end()) return Error{unknown_value(*text, names)};
  return static_cast<std::size_t>(found - names.begin());
}

std::string toml_quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      quoted += fmt::format("\\u{:04X}", static_cast<int>(c));
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

std::string toml_list(const Texts& texts) {
  Texts quoted;
  for (const std::string& text : texts) quoted.push_back(toml_quoted(text));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

std::string toml_list(const std::vector<Texts>& lists) {
  Texts inner;
  for (const Texts& list : lists) inner.push_back(toml_list(list));
  return fmt::format("[{}]", fmt::join(inner, ", "));
}

}  // namespace cls::tournament
