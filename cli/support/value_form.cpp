// Reads the form from the type and the validators that CLI11 appends to it: "INT:INT in [0 - 9]".
#include "cli/support/value_form.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>
#include <vector>

namespace cls::cli {
namespace {

constexpr const char* kWhole = "whole number";
constexpr const char* kUnsigned = "whole number, 0 or more";
constexpr const char* kNumber = "number";
constexpr std::string_view kText = "text as ";

template <class Number>
bool is_number(const std::string& text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return false;
  if constexpr (std::is_floating_point_v<Number>) return std::isfinite(value);
  return true;
}

template <class Number>
void require(CLI::Option& option, const char* description) {
  option.check(CLI::Validator(
      [](const std::string& text) { return is_number<Number>(text) ? "" : "not a number"; },
      description));
}

// "INT:INT in [0 - 9]:POSITIVE" without the type.
std::vector<std::string> constraints(const CLI::Option& option) {
  std::vector<std::string> parts = CLI::detail::split(option.get_type_name(), ':');
  parts.erase(parts.begin());
  return parts;
}

// "INT in [1 - 9]" -> "from 1 to 9"; empty for anything else.
std::string range_form(std::string_view constraint) {
  const std::size_t open = constraint.find(" in [");
  const std::size_t dash = constraint.find(" - ", open);
  if (open == std::string_view::npos || dash == std::string_view::npos) return "";
  const std::string_view low = constraint.substr(open + 5, dash - open - 5);
  const std::string_view high = constraint.substr(dash + 3, constraint.size() - dash - 4);
  return fmt::format("from {} to {}", low, high);
}

// "{a,b,c}" -> a, b, c; empty for anything else.
std::vector<std::string> choices_in(const std::string& constraint) {
  if (!constraint.starts_with('{') || !constraint.ends_with('}')) return {};
  return CLI::detail::split(constraint.substr(1, constraint.size() - 2), ',');
}

// "a, b or c".
std::string choice_form(const std::vector<std::string>& names) {
  std::string form;
  for (std::size_t i = 0; i < names.size(); ++i) {
    form += i == 0 ? "" : i + 1 == names.size() ? " or " : ", ";
    form += names[i];
  }
  return form;
}

}  // namespace

bool is_flag(const CLI::Option& option) { return option.get_expected_min() == 0; }

void require_strict_number(CLI::Option& option) {
  const std::string type = option.get_type_name().substr(0, option.get_type_name().find(':'));
  if (type == "INT") require<std::int64_t>(option, kWhole);
  if (type == "UINT") require<std::uint64_t>(option, kUnsigned);
  if (type == "FLOAT") require<double>(option, kNumber);
}

void require_text(CLI::Option& option, std::string_view form) {
  option.check(CLI::Validator([](const std::string& text) { return text.empty() ? "empty" : ""; },
                              std::string(kText).append(form)));
}

std::vector<std::string> choices(const CLI::Option& option) {
  for (const std::string& constraint : constraints(option)) {
    if (auto names = choices_in(constraint); !names.empty()) return names;
  }
  return {};
}

std::string value_form(const CLI::Option& option) {
  std::string kind;
  std::string limit;
  for (const std::string& constraint : constraints(option)) {
    if (constraint == kWhole || constraint == kUnsigned || constraint == kNumber) {
      kind = "a " + constraint;
    } else if (constraint == "POSITIVE") {
      limit = "above 0";
    } else if (constraint == "NONNEGATIVE") {
      limit = "from 0";
    } else if (const std::string range = range_form(constraint); !range.empty()) {
      limit = range;
    } else if (const auto names = choices_in(constraint); !names.empty()) {
      return choice_form(names);
    } else if (constraint.starts_with(kText)) {
      return constraint.substr(kText.size());
    }
  }
  if (limit.empty()) return kind;
  const std::string noun = kind.substr(0, kind.find(','));
  return noun.empty() ? limit : noun + " " + limit;
}

std::string value_name(const CLI::Option& option) {
  const std::string type = option.get_type_name().substr(0, option.get_type_name().find(':'));
  if (type == "INT" || type == "UINT") return "N";
  if (type == "TEXT") return "VALUE";
  return type == "FLOAT" ? "X" : type;
}

}  // namespace cls::cli
