// Parsing and matching the parts of "when".
#include "mock-server/script/situation_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "mock-server/script/json_parts.h"
#include "proto/playmaker.pb.h"

namespace cls::mock_server {
namespace {

using base::Result;

constexpr int kLastCycle = std::numeric_limits<int>::max() / 2;
constexpr int kMaxUnum = 13;

// One play mode or a list of play modes.
Result<std::vector<Value>> parse_modes(const base::JsonValue& json) {
  const auto& names = *protos::GameModeType_descriptor();
  return one_or_more(json, [&](const base::JsonValue& each) -> Result<Value> {
    TRY_INIT(const auto text, each.string());
    if (names.FindValueByName(text + "_") != nullptr) return Value(text + "_");
    TRY_INIT(const auto word, each.one_of(value_names(names)));
    return Value(word);
  });
}

}  // namespace

Result<CycleRange> parse_cycles(const base::JsonValue& json) {
  CycleRange range;
  if (json.is_array()) {
    if (json.size() != 2) return json.error("a range of cycles is [from, to]");
    TRY_INIT(const auto first, json[0].integer(0, kLastCycle));
    TRY_INIT(const auto last, json[1].integer(first, kLastCycle));
    return CycleRange{first, last, 1};
  }

  if (!json.is_object()) {
    TRY_INIT(const auto cycle, json.integer(0, kLastCycle));
    return CycleRange{cycle, cycle, 1};
  }

  TRY(json.expect_keys({"from", "to", "every"}));
  range.last = kLastCycle;
  for (const auto& [key, member, low] :
       {std::tuple{"from", &range.first, 0}, {"to", &range.last, 0}, {"every", &range.every, 1}}) {
    TRY(read_key(json, key, *member, [least = low](const base::JsonValue& value) {
      return value.integer(least, kLastCycle);
    }));
  }
  return range;
}

Result<std::vector<int>> parse_numbers(const base::JsonValue& json) {
  return one_or_more(json, [](const base::JsonValue& each) { return each.integer(0, kLastCycle); });
}

Result<std::vector<int>> parse_unums(const base::JsonValue& json) {
  TRY_INIT(auto numbers, parse_numbers(json));
  for (const int number : numbers) {
    if (number < 1 || number > kMaxUnum) {
      return json.error(
          fmt::format("{} is not a uniform number (1 to 11, 12 coach, 13 trainer)", number));
    }
  }
  return numbers;
}

Result<SituationFilter> SituationFilter::parse(const base::JsonValue& json, proto::Rpc rpc) {
  TRY(json.expect_keys({"cycle", "mode", "unum", "state"}));

  SituationFilter filter;
  for (const char* key : {"cycle", "mode"}) {
    if (json.has(key) && !is_decision(rpc)) {
      return json[key].error(fmt::format("{} has no {}", name(rpc), key));
    }
  }

  TRY(read_key(json, "cycle", filter.cycles_, parse_cycles));
  TRY(read_key(json, "mode", filter.modes_, parse_modes));
  TRY(read_key(json, "unum", filter.unums_, parse_unums));
  TRY(read_key(json, "state", filter.conditions_, [&](const base::JsonValue& state) {
    return parse_conditions(*request_prototype(rpc).GetDescriptor(), state);
  }));
  return filter;
}

bool SituationFilter::matches(proto::Rpc rpc, const google::protobuf::Message& request) const {
  if (!unums_.empty()) {
    const int unum = caller_of(rpc, request).unum;
    if (std::ranges::find(unums_, unum) == unums_.end()) return false;
  }

  if (cycles_ || !modes_.empty()) {
    const protos::WorldModel& world = static_cast<const protos::State&>(request).world_model();
    if (cycles_ && !cycles_->contains(world.cycle())) return false;
    const Value mode(protos::GameModeType_Name(world.game_mode_type()));
    if (!modes_.empty() && std::ranges::find(modes_, mode) == modes_.end()) return false;
  }

  return std::ranges::all_of(conditions_,
                             [&](const Condition& condition) { return condition.holds(request); });
}

}  // namespace cls::mock_server
