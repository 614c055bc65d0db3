// Parsing and matching the parts of "when".
#include "mock-server/script/situation_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "proto/playmaker.pb.h"

namespace cls::mock_server {
namespace {

using base::Result;

constexpr int kLastCycle = std::numeric_limits<int>::max() / 2;
constexpr int kMaxUnum = 13;

// One play mode or a list of play modes.
Result<std::vector<std::string>> parse_modes(const base::JsonValue& json) {
  std::vector<std::string> modes;
  std::vector<std::string_view> known;
  const auto& names = *protos::GameModeType_descriptor();
  for (int i = 0; i < names.value_count(); ++i) known.push_back(names.value(i)->name());

  const bool list = json.is_array();
  for (std::size_t i = 0; i < (list ? json.size() : 1); ++i) {
    const base::JsonValue each = list ? json[i] : json;
    TRY_INIT(const auto text, each.string());
    if (names.FindValueByName(text + "_") != nullptr) {
      modes.push_back(text + "_");
      continue;
    }
    TRY_INIT(const auto word, each.one_of(known));
    modes.push_back(word);
  }
  return modes;
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
    if (!json.has(key)) continue;
    TRY_INIT(const auto value, json[key].integer(low, kLastCycle));
    *member = value;
  }
  return range;
}

Result<std::vector<int>> parse_numbers(const base::JsonValue& json) {
  std::vector<int> numbers;
  const bool list = json.is_array();
  for (std::size_t i = 0; i < (list ? json.size() : 1); ++i) {
    TRY_INIT(const auto number, (list ? json[i] : json).integer(0, kLastCycle));
    numbers.push_back(number);
  }
  return numbers;
}

Result<std::vector<int>> parse_unums(const base::JsonValue& json) {
  auto numbers = parse_numbers(json);
  if (!numbers) return numbers;
  for (const int number : *numbers) {
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

  if (json.has("cycle")) {
    TRY_INIT(const auto cycles, parse_cycles(json["cycle"]));
    filter.cycles_ = cycles;
  }
  if (json.has("mode")) {
    TRY_INIT(const auto modes, parse_modes(json["mode"]));
    for (const std::string& mode : modes) filter.modes_.emplace_back(mode);
  }
  if (json.has("unum")) {
    TRY_INIT(const auto unums, parse_unums(json["unum"]));
    filter.unums_ = unums;
  }
  if (json.has("state")) {
    TRY_INIT(auto conditions,
             parse_conditions(*request_prototype(rpc).GetDescriptor(), json["state"]));
    filter.conditions_ = std::move(conditions);
  }

  return filter;
}

bool SituationFilter::matches(proto::Rpc rpc, const google::protobuf::Message& request) const {
  if (!unums_.empty()) {
    const int unum = caller_of(rpc, request).unum;
    if (std::find(unums_.begin(), unums_.end(), unum) == unums_.end()) return false;
  }

  if (cycles_ || !modes_.empty()) {
    const protos::WorldModel& world = static_cast<const protos::State&>(request).world_model();
    if (cycles_ && !cycles_->contains(world.cycle())) return false;
    const Value mode(protos::GameModeType_Name(world.game_mode_type()));
    if (!modes_.empty() && std::find(modes_.begin(), modes_.end(), mode) == modes_.end()) {
      return false;
    }
  }

  return std::all_of(conditions_.begin(), conditions_.end(),
                     [&](const Condition& condition) { return condition.holds(request); });
}

}  // namespace cls::mock_server
