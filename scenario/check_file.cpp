// Parses the checks of a scenario: one function per kind of check.
#include "scenario/check_file.h"

#include <fmt/format.h>

#include "base/text/json.h"
#include "base/text/number_text.h"
#include "base/text/suggestion.h"
#include "proto/playmaker.pb.h"
#include "scenario/referee_messages.h"
#include "scenario/scenario.h"
#include "soccer/areas.h"
#include "soccer/side.h"

namespace cls::scenario {
namespace {

using base::Error;
using base::JsonDocument;
using base::JsonValue;
using base::Result;
using mock_server::Comparison;
using soccer::PlayMode;
using soccer::Side;
using Words = std::vector<std::string_view>;

constexpr int kLastStep = 1'000'000;

Result<Comparison> parse_count(const JsonValue& json) {
  if (json.has("count")) return Comparison::parse_number(json["count"]);
  const auto any = JsonDocument::parse("", R"({">=": 1})");
  return Comparison::parse_number(JsonValue(*any));
}

// "left 9".
Result<int> parse_player(const JsonValue& json) {
  TRY_INIT(const auto text, json.string());
  const std::size_t space = text.find(' ');
  const auto side = soccer::parse_side(text.substr(0, space));
  const std::size_t number = space == std::string::npos ? text.size() : space + 1;
  const int unum = base::parse_int(text.substr(number)).value_or(0);
  if (!side || !soccer::is_unum(unum)) {
    return json.error(fmt::format("'{}' is not a player; use the form \"left 9\"", text));
  }
  return soccer::slot_of(*side, unum);
}

// "left 9", or "left" for its whole team.
Result<std::vector<int>> parse_players(const JsonValue& json) {
  if (json.is_string()) {
    if (const auto side = soccer::parse_side(*json.string())) {
      std::vector<int> slots;
      for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
        slots.push_back(soccer::slot_of(*side, unum));
      }
      return slots;
    }
  }
  TRY_INIT(const auto slot, parse_player(json));
  return std::vector<int>{slot};
}

Result<void> parse_near(const JsonValue& json, ObjectTest& test) {
  ObjectTest::Nearness near;
  if (json["near"].is_array()) {
    TRY_INIT(near.point, parse_point(json["near"]));
  } else if (json["near"].is_string() && *json["near"].string() == "ball") {
    near.object = kBallObject;
  } else {
    TRY_INIT(near.object, parse_player(json["near"]));
  }
  if (!json.has("within")) return json.error("\"near\" requires \"within\", in meters");

  TRY_INIT(near.within, json["within"].number(0, 200));
  test.near = near;
  return {};
}

// The object behind "is": {"x": ..., "in": ..., "near": ...}.
Result<void> parse_is(const JsonValue& json, ObjectTest& test) {
  using Quantity = ObjectTest::Quantity;
  constexpr const auto& kQuantities = Quantity::kNames.texts;
  Words known(kQuantities.begin(), kQuantities.end());
  known.insert(known.end(), {"in", "near", "within"});
  TRY(json.expect_keys(known));
  if (json.size() == 0) return json.error("contains no condition");

  for (const std::string_view name : kQuantities) {
    if (!json.has(name)) continue;
    const auto what = *Quantity::kNames.parse(name);
    mock_server::ValueKind kind;
    if (what == Quantity::What::kOnPitch) kind.kind = mock_server::ValueKind::Kind::kBool;
    TRY_INIT(auto expected, Comparison::parse(json[name], kind));
    test.quantities.push_back({what, std::move(expected)});
  }
  if (json.has("in")) {
    for (const JsonValue& each : elements_of(json["in"])) {
      TRY_INIT(auto area, each.one_of(soccer::area_names()));
      test.areas.push_back(std::move(area));
    }
  }

  return json.has("near") ? parse_near(json, test) : Result<void>();
}

Result<std::vector<PlayMode>> parse_modes(const JsonValue& json) {
  std::vector<PlayMode> modes;
  for (const JsonValue& each : elements_of(json)) {
    TRY_INIT(const auto mode, parse_mode(each));
    modes.push_back(mode);
  }
  return modes;
}

// The condition of a step check, without its timing.
Result<StepTest> parse_test(const JsonValue& json) {
  StepTest test;
  if (json.has("mode")) {
    TRY_INIT(test.modes, parse_modes(json["mode"]));
  } else if (json.has("goals")) {
    TRY_INIT(test.goals, json["goals"].integer(1, kLastStep));
  } else if (json.has("touch_by")) {
    TRY_INIT(test.touch_by, parse_players(json["touch_by"]));
  } else {
    ObjectTest object;
    if (json.has("player")) {
      TRY_INIT(object.object, parse_player(json["player"]));
      if (!json.has("is")) return json.error("requires \"is\"");
    }
    TRY(parse_is(json[json.has("player") ? "is" : "ball"], object));
    test.object = std::move(object);
  }

  return test;
}

Result<CheckTiming> parse_timing(const JsonValue& json, int steps, bool is_mode) {
  CheckTiming timing{is_mode ? CheckTiming::How::kSometime : CheckTiming::How::kEnd, 0, kLastStep};
  if (json.has("at") && !(json["at"].is_string() && *json["at"].string() == "end")) {
    TRY_INIT(const auto at, json["at"].integer(0, steps));
    return CheckTiming{CheckTiming::How::kAt, at, at};
  }
  if (json.has("at")) return CheckTiming{CheckTiming::How::kEnd, 0, kLastStep};

  for (const auto& [key, how] : {std::pair{"sometime", CheckTiming::How::kSometime},
                                 std::pair{"always", CheckTiming::How::kAlways},
                                 std::pair{"never", CheckTiming::How::kNever}}) {
    if (!json.has(key)) continue;
    const JsonValue range = json[key];
    timing.how = how;
    if (range.is_array()) {
      if (range.size() != 2) return range.error("a range of steps is [from, to]");
      TRY_INIT(const auto from, range[0].integer(0, steps));
      TRY_INIT(const auto to, range[1].integer(from, steps));
      timing.from = from;
      timing.to = to;
    } else if (const auto flag = range.boolean(); !flag || !*flag) {
      return range.error("must be true or a range of steps");
    }
  }

  return timing;
}

const Words kCommon = {"name", "runs"};

Result<void> only(const JsonValue& json, Words keys) {
  keys.insert(keys.end(), kCommon.begin(), kCommon.end());
  return json.expect_keys(keys);
}

using Parsed = Result<decltype(Check::what)>;

/// The values that a check may depend on.
struct Context {
  int steps = 0;  ///< of the run
  const base::Json& golden;
};

Parsed parse_step_check(const JsonValue& json, const Context& context) {
  Words keys = {"mode"};
  if (json.has("player")) keys = {"player", "is"};
  if (json.has("ball")) keys = {"ball"};
  keys.insert(keys.end(), {"at", "sometime", "always", "never"});
  TRY(only(json, keys));
  StepCheck check;
  TRY_INIT(const auto test, parse_test(json));
  check.test = test;
  TRY_INIT(check.timing, parse_timing(json, context.steps, !test.modes.empty()));
  return {check};
}

Parsed parse_score(const JsonValue& json, const Context& /*context*/) {
  TRY(only(json, {"score"}));
  const JsonValue score = json["score"];
  ScoreCheck check;
  if (score.is_array() && score.size() != 2) return score.error("a score is [left, right]");
  if (!score.is_array()) {
    TRY(score.expect_keys({"left", "right"}));
  }

  for (std::size_t side = 0; side < 2; ++side) {
    const char* key = side == 0 ? "left" : "right";
    if (!score.is_array() && !score.has(key)) continue;
    TRY_INIT(check.goals[side],
             Comparison::parse_number(score.is_array() ? score[side] : score[key]));
  }

  return {check};
}

Parsed parse_referee(const JsonValue& json, const Context& /*context*/) {
  TRY(only(json, {"referee", "count"}));
  TRY_INIT(const auto message, json["referee"].string());
  if (!is_referee_message(message)) {
    return json["referee"].error(fmt::format("unknown referee message '{}'{}", message,
                                             base::did_you_mean(message, referee_messages())));
  }
  TRY_INIT(const auto count, parse_count(json));
  return {RefereeCheck{message, count}};
}

Parsed parse_touch(const JsonValue& json, const Context& /*context*/) {
  TouchCheck check;
  const char* key = "touches";
  for (const auto& [name, which] : {std::pair{"touches", TouchCheck::Which::kCount},
                                    std::pair{"first_touch", TouchCheck::Which::kFirst},
                                    std::pair{"last_touch", TouchCheck::Which::kLast}}) {
    if (!json.has(name)) continue;
    check.which = which;
    key = name;
  }

  Words keys = {key};
  if (check.which == TouchCheck::Which::kCount) keys.push_back("count");
  TRY(only(json, keys));
  TRY_INIT(check.slots, parse_players(json[key]));
  check.who = *json[key].string();
  TRY_INIT(check.count, parse_count(json));

  return {check};
}

Result<void> parse_who(const JsonValue& json, Side& side, std::vector<int>& unums) {
  if (!json.has("side")) return json.error("requires \"side\"");
  TRY_INIT(side, parse_side(json["side"]));
  if (!json.has("unum")) return {};
  TRY_INIT(unums, mock_server::parse_unums(json["unum"]));
  return {};
}

Parsed parse_actions(const JsonValue& json, const Context& context) {
  TRY(only(json, {"actions", "side", "unum", "steps", "position", "where", "count"}));
  ActionCheck check;
  TRY(parse_who(json, check.side, check.unums));
  const auto* fields = protos::PlayerAction::descriptor();
  Words kinds = {"*"};
  for (int i = 0; i < fields->field_count(); ++i) kinds.push_back(fields->field(i)->name());
  TRY_INIT(check.kind, json["actions"].one_of(kinds));
  check.to = context.steps;
  if (json.has("steps")) {
    TRY_INIT(const auto range, mock_server::parse_cycles(json["steps"]));
    check.from = range.first;
    check.to = range.last;
  }

  if (json.has("position")) {
    TRY(json["position"].one_of({"first"}));
    check.first_only = true;
  }

  if (json.has("where")) {
    TRY_INIT(check.where, mock_server::parse_conditions(*fields, json["where"]));
  }

  TRY_INIT(check.count, parse_count(json));
  return {std::move(check)};
}

Parsed parse_commands(const JsonValue& json, const Context& /*context*/) {
  TRY(only(json, {"commands", "side", "unum", "count"}));
  CommandCheck check;
  TRY(parse_who(json, check.side, check.unums));
  TRY_INIT(check.kind, json["commands"].one_of({"dash", "turn", "kick", "tackle", "catch", "move",
                                                "turn_neck", "change_view", "say", "pointto",
                                                "attentionto", "change_focus"}));
  TRY_INIT(check.count, parse_count(json));
  return {std::move(check)};
}

Parsed parse_rpc(const JsonValue& json, const Context& /*context*/) {
  TRY(only(json, {"rpc", "order", "side", "when", "count", "count_per_agent", "always"}));
  RpcCheck check;
  std::vector<int> none;
  TRY(parse_who(json, check.side, none));
  TRY_INIT(check.expectation, mock_server::parse_expectation(json, {"side", "runs"}));
  return {std::move(check)};
}

Parsed parse_latency(const JsonValue& json, const Context& /*context*/) {
  TRY(only(json, {"latency_ms", "side"}));
  LatencyCheck check;
  std::vector<int> none;
  TRY(parse_who(json, check.side, none));
  const JsonValue parts = json["latency_ms"];
  TRY(parts.expect_keys({"p50", "p95", "p99", "max"}));
  for (const std::string& key : parts.keys()) {
    TRY_INIT(const auto expected, Comparison::parse_number(parts[key]));
    check.percentiles_ms.emplace(key, expected);
  }
  return {std::move(check)};
}

Parsed parse_missed(const JsonValue& json, const Context& /*context*/) {
  TRY(only(json, {"missed", "side"}));
  MissedCheck check;
  std::vector<int> none;
  TRY(parse_who(json, check.side, none));
  TRY_INIT(check.count, Comparison::parse_number(json["missed"]));
  return {check};
}

Parsed parse_end(const JsonValue& json, const Context& /*context*/) {
  TRY(only(json, {"end"}));
  std::vector<std::string_view> names;
  for (const soccer::EndReasonRow& row : soccer::end_reasons()) {
    if (row.traits.expectable) names.push_back(row.name);
  }
  TRY_INIT(const auto reason, json["end"].one_of(names));
  return {EndCheck{*soccer::parse_end_reason(reason)}};
}

Parsed parse_golden(const JsonValue& json, const Context& context) {
  TRY(only(json, {"golden"}));
  TRY_INIT(const auto what, json["golden"].one_of({"game_log", "score", "touches"}));
  return {GoldenCheck{what, context.golden.is_object() ? context.golden.value(what, "") : ""}};
}

struct CheckKind {
  std::string_view key;
  Parsed (*parse)(const JsonValue& json, const Context& context);
};

constexpr CheckKind kKinds[] = {
    {"ball", parse_step_check},    {"player", parse_step_check}, {"mode", parse_step_check},
    {"score", parse_score},        {"referee", parse_referee},   {"touches", parse_touch},
    {"first_touch", parse_touch},  {"last_touch", parse_touch},  {"actions", parse_actions},
    {"commands", parse_commands},  {"rpc", parse_rpc},           {"order", parse_rpc},
    {"latency_ms", parse_latency}, {"missed", parse_missed},     {"end", parse_end},
    {"golden", parse_golden},
};

Parsed parse_what(const JsonValue& json, const Context& context) {
  if (!json.is_object()) return json.error("must be an object");
  Words keys;
  for (const CheckKind& kind : kKinds) {
    if (json.has(kind.key)) return kind.parse(json, context);
    keys.push_back(kind.key);
  }

  for (const std::string& key : json.keys()) {
    const std::string hint = base::did_you_mean(key, keys);
    if (!hint.empty()) return json.error(fmt::format("unknown kind of check '{}'{}", key, hint));
  }
  return json.error(fmt::format("missing kind of check (known: {})", fmt::join(keys, ", ")));
}

}  // namespace

std::vector<JsonValue> elements_of(const JsonValue& json) {
  if (!json.is_array()) return {json};
  std::vector<JsonValue> elements;
  for (std::size_t i = 0; i < json.size(); ++i) elements.push_back(json[i]);
  return elements;
}

Result<std::string> text_in(const JsonValue& json) { return json.string(); }

Result<soccer::Vec2> parse_point(const JsonValue& json) {
  if (!json.is_array() || json.size() != 2) return json.error("must be [x, y]");
  soccer::Vec2 point;
  for (const auto& [index, member] :
       {std::pair{std::size_t{0}, &point.x}, std::pair{std::size_t{1}, &point.y}}) {
    TRY_INIT(*member, json[index].number(-100, 100));
  }
  return point;
}

Result<Side> parse_side(const JsonValue& json) {
  TRY_INIT(const auto name, json.one_of({"left", "right"}));
  return *soccer::parse_side(name);
}

Result<PlayMode> parse_mode(const JsonValue& json) {
  Words names;
  for (int i = 1; i < soccer::kPlayModeCount; ++i) names.push_back(name(static_cast<PlayMode>(i)));
  TRY_INIT(const auto name, json.one_of(names));
  return *soccer::parse_play_mode(name);
}

Result<StepTest> parse_step_test(const JsonValue& json) {
  if (!json.is_object()) return json.error("must be an object");
  const Words kinds = {"mode", "goals", "touch_by", "ball", "player"};
  for (const std::string_view kind : kinds) {
    if (!json.has(kind)) continue;
    TRY(json.expect_keys(kind == "player" ? Words{"player", "is"} : Words{kind}));
    return parse_test(json);
  }
  return json.error(fmt::format("missing condition (known: {})", fmt::join(kinds, ", ")));
}

Result<Check> parse_check(const JsonValue& json, int steps, const base::Json& golden) {
  Check check;
  TRY_INIT(check.what, parse_what(json, {steps, golden}));
  check.line = json.line();
  check.name = json.json().dump();
  TRY(parse_if(json, "name", text_in, check.name));
  TRY(parse_if(json, "runs", Comparison::parse_number, check.runs));

  return check;
}

}  // namespace cls::scenario
