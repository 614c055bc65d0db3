// The rows of the key table of stages.
#include "tournament/config/stage_keys.h"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "base/text/suggestion.h"

namespace cls::tournament {
namespace {

using base::Error;
using base::Result;

constexpr std::array kStageFormats = {StageFormat::kGroups, StageFormat::kKnockout,
                                      StageFormat::kStepladder};
constexpr int kMaxStageNumber = 1000;

std::string quoted_list(const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back(toml_quoted(name));
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

StageKey names(std::string_view key, std::vector<std::string> Stage::*member) {
  return {key,
          [=](Stage& stage, const ConfigValue& value) -> Result<void> {
            const auto* read = std::get_if<std::vector<std::string>>(&value);
            if (read == nullptr) return Error{"must be a list of names, [\"A\", \"B\"]"};
            stage.*member = *read;
            return {};
          },
          [=](const Stage& stage) {
            return (stage.*member).empty() ? std::string() : quoted_list(stage.*member);
          }};
}

std::optional<int> number_from(const ConfigValue& value, int min) {
  const auto* read = std::get_if<std::int64_t>(&value);
  if (read == nullptr || *read < min || *read > kMaxStageNumber) return std::nullopt;
  return static_cast<int>(*read);
}

StageKey number(std::string_view key, int Stage::*member, int min) {
  return {
      key,
      [=](Stage& stage, const ConfigValue& value) -> Result<void> {
        const auto read = number_from(value, min);
        if (!read) {
          return Error{fmt::format("must be a whole number from {} to {}", min, kMaxStageNumber)};
        }
        stage.*member = *read;
        return {};
      },
      [=](const Stage& stage) {
        return stage.*member == Stage().*member ? std::string() : fmt::to_string(stage.*member);
      }};
}

Result<void> parse_name(Stage& stage, const ConfigValue& value) {
  const auto* read = std::get_if<std::string>(&value);
  if (read == nullptr) return Error{"must be a string"};
  stage.name = *read;
  return {};
}

Result<void> parse_format(Stage& stage, const ConfigValue& value) {
  std::vector<std::string_view> known;
  for (const StageFormat format : kStageFormats) known.push_back(name(format));
  const auto* read = std::get_if<std::string>(&value);
  for (const StageFormat format : kStageFormats) {
    if (read == nullptr || *read != name(format)) continue;
    stage.format = format;
    return {};
  }
  const std::string_view near = read == nullptr ? "" : base::nearest_name(*read, known);
  return Error{near.empty() ? fmt::format("must be one of {}", fmt::join(known, ", "))
                            : fmt::format("did you mean '{}'?", near)};
}

Result<void> parse_groups(Stage& stage, const ConfigValue& value) {
  if (const auto* drawn = std::get_if<std::vector<std::vector<std::string>>>(&value)) {
    stage.drawn = *drawn;
    return {};
  }
  const auto count = number_from(value, 1);
  if (!count) {
    return Error{
        "must be a number of groups, or the groups by name, [[\"A\", \"B\"], [\"C\", \"D\"]]"};
  }
  stage.groups = *count;
  return {};
}

std::string format_groups(const Stage& stage) {
  if (stage.drawn.empty()) return stage.groups == 1 ? "" : fmt::to_string(stage.groups);
  std::vector<std::string> groups;
  for (const auto& group : stage.drawn) groups.push_back(quoted_list(group));
  return fmt::format("[{}]", fmt::join(groups, ", "));
}

Result<void> parse_divisions(Stage& stage, const ConfigValue& value) {
  const Error error{"must be a list of sizes from 2, [5, 4]"};
  const auto* sizes = std::get_if<std::vector<std::int64_t>>(&value);
  if (sizes == nullptr) return error;
  stage.divisions.clear();
  for (const std::int64_t size : *sizes) {
    if (size < 2 || size > kMaxStageNumber) return error;
    stage.divisions.push_back(static_cast<int>(size));
  }
  return {};
}

Result<void> parse_third_place(Stage& stage, const ConfigValue& value) {
  const auto* read = std::get_if<bool>(&value);
  if (read == nullptr) return Error{"must be true or false"};
  stage.third_place = *read;
  return {};
}

}  // namespace

const std::vector<StageKey>& stage_keys() {
  static const std::vector<StageKey> keys = {
      {"name", parse_name, [](const Stage& stage) { return toml_quoted(stage.name); }},
      {"format", parse_format, [](const Stage& stage) { return toml_quoted(name(stage.format)); }},
      names("ranked_by", &Stage::ranked_by),
      {"groups", parse_groups, format_groups},
      {"divisions", parse_divisions,
       [](const Stage& stage) {
         return stage.divisions.empty() ? std::string()
                                        : fmt::format("[{}]", fmt::join(stage.divisions, ", "));
       }},
      number("legs", &Stage::legs, 1),
      number("teams", &Stage::teams, 2),
      names("join", &Stage::join),
      names("carry", &Stage::carry),
      {"third_place", parse_third_place,
       [](const Stage& stage) { return std::string(stage.third_place ? "" : "false"); }},
  };
  return keys;
}

}  // namespace cls::tournament
