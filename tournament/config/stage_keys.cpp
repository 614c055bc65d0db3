// The rows of the key table of stages.
#include "tournament/config/stage_keys.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/suggestion.h"

namespace cls::tournament {
namespace {

using base::Error;
using base::Result;
using league::StageFormat;

constexpr int kMaxStageNumber = 1000;

enum class When { kAlways, kIfSet };  // written

template <class Value>
StageKey row(std::string_view key, Value Stage::*member, ValueType<Value> type,
             When written = When::kIfSet) {
  return {.name = key,
          .parse = [=](Stage& stage, const ConfigValue& value) -> Result<void> {
            TRY_INIT(stage.*member, type.parse(value));
            return {};
          },
          .format =
              [=](const Stage& stage) {
                const bool is_default = stage.*member == Stage().*member;
                return is_default && written == When::kIfSet ? std::string()
                                                             : type.format(stage.*member);
              }};
}

ValueType<Texts> names() { return texts("must be a list of names, [\"A\", \"B\"]"); }

ValueType<std::string> stage_name() {
  ValueType<std::string> type = text();
  type.format = [](const std::string& name) { return toml_quoted(name); };
  return type;
}

ValueType<StageFormat> stage_format() {
  const std::vector<std::string_view> known = list_of(league::kStageFormats);
  ValueType<StageFormat> type = choice<StageFormat>(known);
  type.parse = [known](const ConfigValue& value) -> Result<StageFormat> {
    const auto* read = std::get_if<std::string>(&value);
    if (read != nullptr) {
      if (const auto format = league::kStageFormats.parse(*read)) return *format;
    }
    const std::string_view near = read == nullptr ? "" : base::nearest_name(*read, known);
    return Error{near.empty() ? fmt::format("must be one of {}", fmt::join(known, ", "))
                              : fmt::format("did you mean '{}'?", near)};
  };
  return type;
}

ValueType<std::vector<int>> divisions() {
  return {
      read_list,
      [](const ConfigValue& value) -> Result<std::vector<int>> {
        const auto* sizes = std::get_if<std::vector<std::int64_t>>(&value);
        const auto fits = [](std::int64_t size) { return size >= 2 && size <= kMaxStageNumber; };
        if (sizes == nullptr || !std::ranges::all_of(*sizes, fits)) {
          return Error{"must be a list of sizes from 2, [5, 4]"};
        }
        return std::vector<int>(sizes->begin(), sizes->end());
      },
      [](const std::vector<int>& sizes) { return fmt::format("[{}]", fmt::join(sizes, ", ")); }};
}

// A number of groups, or the groups themselves.
Result<void> parse_groups(Stage& stage, const ConfigValue& value) {
  if (const auto* drawn = std::get_if<std::vector<Texts>>(&value)) {
    stage.drawn = *drawn;
    return {};
  }
  const auto count = whole(1, kMaxStageNumber).parse(value);
  if (!count) {
    return Error{
        "must be a number of groups, or the groups by name, [[\"A\", \"B\"], [\"C\", \"D\"]]"};
  }
  stage.groups = *count;
  return {};
}

std::string format_groups(const Stage& stage) {
  if (!stage.drawn.empty()) return toml_list(stage.drawn);
  return stage.groups == 1 ? "" : fmt::to_string(stage.groups);
}

}  // namespace

const std::vector<StageKey>& stage_keys() {
  static const std::vector<StageKey> keys = {
      row("name", &Stage::name, stage_name(), When::kAlways),
      row("format", &Stage::format, stage_format(), When::kAlways),
      row("ranked_by", &Stage::ranked_by, names()),
      {.name = "groups", .parse = parse_groups, .format = format_groups},
      row("divisions", &Stage::divisions, divisions()),
      row("legs", &Stage::legs, whole(1, kMaxStageNumber)),
      row("teams", &Stage::teams, whole(2, kMaxStageNumber)),
      row("join", &Stage::join, names()),
      row("carry", &Stage::carry, names()),
      row("third_place", &Stage::third_place, flag()),
  };
  return keys;
}

}  // namespace cls::tournament
