// Parses the checks of a scenario: one function per kind of check.
#include "orchestration/scenario/check_file.h"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "base/text/suggestion.h"
#include "orchestration/scenario/referee_messages.h"
#include "orchestration/scenario/scenario.h"
#include "proto/playmaker.pb.h"
#include "soccer/areas.h"
#include "soccer/side.h"

namespace cls::orchestration::scenario {
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
  const auto text = json.string();
  if (!text) return text.error();
  const std::size_t space = text->find(' ');
  const auto side = soccer::parse_side(text->substr(0, space));
  int unum = 0;
  const char* end = text->data() + text->size();
  const char* begin = space == std::string::npos ? end : text->data() + space + 1;
  const auto [stop, code] = std::from_chars(begin, end, unum);
  if (!side || code != std::errc{} || stop != end || unum < 1 || unum > soccer::kPlayersPerTeam) {
    return json.error(fmt::format("'{}' is not a player; use the form \"left 9\"", *text));
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
  const auto slot = parse_player(json);
  if (!slot) return slot.error();
  return std::vector<int>{*slot};
}

Result<void> parse_near(const JsonValue& json, ObjectTest& test) {
  ObjectTest::Nearness near;
  if (json["near"].is_array()) {
    const auto point = parse_point(json["near"]);
    if (!point) return point.error();
    near.point = *point;
  } else if (json["near"].is_string() && *json["near"].string() == "ball") {
    near.object = kBallObject;
  } else {
    const auto slot = parse_player(json["near"]);
    if (!slot) return slot.error();
    near.object = *slot;
  }
  if (!json.has("within")) return json.error("\"near\" requires \"within\", in meters");
  const auto within = json["within"].number(0, 200);
  if (!within) return within.error();
  near.within = *within;
  test.near = near;
  return {};
}

// The object behind "is": {"x": ..., "in": ..., "near": ...}.
Result<void> parse_is(const JsonValue& json, ObjectTest& test) {
  static const Words quantities = {"x", "y", "speed", "body", "stamina", "cards", "on_pitch"};
  Words known = quantities;
  known.insert(known.end(), {"in", "near", "within"});
  if (const auto keys = json.expect_keys(known); !keys) return keys;
  if (json.size() == 0) return json.error("contains no condition");
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (!json.has(quantities[i])) continue;
    using What = ObjectTest::Quantity::What;
    const auto what = static_cast<What>(i);
    mock_server::ValueKind kind;
    if (what == What::kOnPitch) kind.kind = mock_server::ValueKind::Kind::kBool;
    const auto expected = Comparison::parse(json[quantities[i]], kind);
    if (!expected) return expected.error();
    test.quantities.push_back({what, *expected});
  }
  if (json.has("in")) {
    const JsonValue areas = json["in"];
    for (std::size_t i = 0; i < (areas.is_array() ? areas.size() : 1); ++i) {
      const auto area = (areas.is_array() ? areas[i] : areas).one_of(soccer::area_names());
      if (!area) return area.error();
      test.areas.push_back(*area);
    }
  }
  return json.has("near") ? parse_near(json, test) : Result<void>();
}

Result<std::vector<PlayMode>> parse_modes(const JsonValue& json) {
  std::vector<PlayMode> modes;
  for (std::size_t i = 0; i < (json.is_array() ? json.size() : 1); ++i) {
    const auto mode = parse_mode(json.is_array() ? json[i] : json);
    if (!mode) return mode.error();
    modes.push_back(*mode);
  }
  return modes;
}

// The condition of a step check, without its timing.
Result<StepTest> parse_test(const JsonValue& json) {
  StepTest test;
  if (json.has("mode")) {
    const auto modes = parse_modes(json["mode"]);
    if (!modes) return modes.error();
    test.modes = *modes;
  } else if (json.has("goals")) {
    const auto goals = json["goals"].integer(1, kLastStep);
    if (!goals) return goals.error();
    test.goals = *goals;
  } else if (json.has("touch_by")) {
    const auto slots = parse_players(json["touch_by"]);
    if (!slots) return slots.error();
    test.touch_by = *slots;
  } else {
    ObjectTest object;
    if (json.has("player")) {
      const auto slot = parse_player(json["player"]);
      if (!slot) return slot.error();
      object.object = *slot;
      if (!json.has("is")) return json.error("requires \"is\"");
    }
    if (const auto is = parse_is(json[json.has("player") ? "is" : "ball"], object); !is) {
      return is.error();
    }
    test.object = std::move(object);
  }
  return test;
}

Result<CheckTiming> parse_timing(const JsonValue& json, int steps, bool is_mode) {
  CheckTiming timing{is_mode ? CheckTiming::How::kSometime : CheckTiming::How::kEnd, 0, kLastStep};
  if (json.has("at") && !(json["at"].is_string() && *json["at"].string() == "end")) {
    const auto at = json["at"].integer(0, steps);
    if (!at) return at.error();
    return CheckTiming{CheckTiming::How::kAt, *at, *at};
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
      const auto from = range[0].integer(0, steps);
      if (!from) return from.error();
      const auto to = range[1].integer(*from, steps);
      if (!to) return to.error();
      timing.from = *from;
      timing.to = *to;
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

Parsed parse_step_check(const JsonValue& json, int steps, Words keys) {
  keys.insert(keys.end(), {"at", "sometime", "always", "never"});
  if (const auto known = only(json, keys); !known) return known.error();
  StepCheck check;
  const auto test = parse_test(json);
  if (!test) return test.error();
  check.test = *test;
  const auto timing = parse_timing(json, steps, !test->modes.empty());
  if (!timing) return timing.error();
  check.timing = *timing;
  return {check};
}

Parsed parse_score(const JsonValue& json) {
  if (const auto known = only(json, {"score"}); !known) return known.error();
  const JsonValue score = json["score"];
  ScoreCheck check;
  if (score.is_array() && score.size() != 2) return score.error("a score is [left, right]");
  if (!score.is_array()) {
    if (const auto known = score.expect_keys({"left", "right"}); !known) return known.error();
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const char* key = side == 0 ? "left" : "right";
    if (!score.is_array() && !score.has(key)) continue;
    const auto goals = Comparison::parse_number(score.is_array() ? score[side] : score[key]);
    if (!goals) return goals.error();
    check.goals[side] = *goals;
  }
  return {check};
}

Parsed parse_referee(const JsonValue& json) {
  if (const auto known = only(json, {"referee", "count"}); !known) return known.error();
  const auto message = json["referee"].string();
  if (!message) return message.error();
  if (!is_referee_message(*message)) {
    return json["referee"].error(fmt::format("unknown referee message '{}'{}", *message,
                                             base::did_you_mean(*message, referee_messages())));
  }
  const auto count = parse_count(json);
  if (!count) return count.error();
  return {RefereeCheck{*message, *count}};
}

Parsed parse_touch(const JsonValue& json) {
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
  if (const auto known = only(json, keys); !known) return known.error();
  const auto slots = parse_players(json[key]);
  if (!slots) return slots.error();
  check.slots = *slots;
  check.who = *json[key].string();
  const auto count = parse_count(json);
  if (!count) return count.error();
  check.count = *count;
  return {check};
}

Result<void> parse_who(const JsonValue& json, Side& side, std::vector<int>& unums) {
  if (!json.has("side")) return json.error("requires \"side\"");
  const auto which = parse_side(json["side"]);
  if (!which) return which.error();
  side = *which;
  if (!json.has("unum")) return {};
  const auto numbers = mock_server::parse_unums(json["unum"]);
  if (!numbers) return numbers.error();
  unums = *numbers;
  return {};
}

Parsed parse_actions(const JsonValue& json, int steps) {
  const auto known = only(json, {"actions", "side", "unum", "steps", "position", "where", "count"});
  if (!known) return known.error();
  ActionCheck check;
  if (const auto who = parse_who(json, check.side, check.unums); !who) return who.error();
  const auto* fields = protos::PlayerAction::descriptor();
  Words kinds = {"*"};
  for (int i = 0; i < fields->field_count(); ++i) kinds.push_back(fields->field(i)->name());
  const auto kind = json["actions"].one_of(kinds);
  if (!kind) return kind.error();
  check.kind = *kind;
  check.to = steps;
  if (json.has("steps")) {
    const auto range = mock_server::parse_cycles(json["steps"]);
    if (!range) return range.error();
    check.from = range->first;
    check.to = range->last;
  }
  if (json.has("position")) {
    if (const auto position = json["position"].one_of({"first"}); !position)
      return position.error();
    check.first_only = true;
  }
  if (json.has("where")) {
    auto where = mock_server::parse_conditions(*fields, json["where"]);
    if (!where) return where.error();
    check.where = *std::move(where);
  }
  const auto count = parse_count(json);
  if (!count) return count.error();
  check.count = *count;
  return {std::move(check)};
}

Parsed parse_commands(const JsonValue& json) {
  if (const auto known = only(json, {"commands", "side", "unum", "count"}); !known) {
    return known.error();
  }
  CommandCheck check;
  if (const auto who = parse_who(json, check.side, check.unums); !who) return who.error();
  const auto kind =
      json["commands"].one_of({"dash", "turn", "kick", "tackle", "catch", "move", "turn_neck",
                               "change_view", "say", "pointto", "attentionto", "change_focus"});
  if (!kind) return kind.error();
  check.kind = *kind;
  const auto count = parse_count(json);
  if (!count) return count.error();
  check.count = *count;
  return {std::move(check)};
}

Parsed parse_rpc(const JsonValue& json) {
  const auto known =
      only(json, {"rpc", "order", "side", "when", "count", "count_per_agent", "always"});
  if (!known) return known.error();
  RpcCheck check;
  std::vector<int> none;
  if (const auto who = parse_who(json, check.side, none); !who) return who.error();
  auto expectation = mock_server::parse_expectation(json, {"side", "runs"});
  if (!expectation) return expectation.error();
  check.expectation = *std::move(expectation);
  return {std::move(check)};
}

Parsed parse_latency(const JsonValue& json) {
  if (const auto known = only(json, {"latency_ms", "side"}); !known) return known.error();
  LatencyCheck check;
  std::vector<int> none;
  if (const auto who = parse_who(json, check.side, none); !who) return who.error();
  const JsonValue parts = json["latency_ms"];
  if (const auto keys = parts.expect_keys({"p50", "p95", "p99", "max"}); !keys) return keys.error();
  for (const std::string& key : parts.keys()) {
    const auto expected = Comparison::parse_number(parts[key]);
    if (!expected) return expected.error();
    check.percentiles_ms.emplace(key, *expected);
  }
  return {std::move(check)};
}

Parsed parse_missed(const JsonValue& json) {
  if (const auto known = only(json, {"missed", "side"}); !known) return known.error();
  MissedCheck check;
  std::vector<int> none;
  if (const auto who = parse_who(json, check.side, none); !who) return who.error();
  const auto count = Comparison::parse_number(json["missed"]);
  if (!count) return count.error();
  check.count = *count;
  return {check};
}

Parsed parse_end(const JsonValue& json) {
  if (const auto known = only(json, {"end"}); !known) return known.error();
  using match::EndReason;
  std::vector<std::string_view> names;
  for (const EndReason reason :
       {EndReason::kFinished, EndReason::kCrashed, EndReason::kStalled, EndReason::kLate,
        EndReason::kRefused, EndReason::kProtocolError, EndReason::kTimedOut}) {
    names.push_back(name(reason));
  }
  const auto reason = json["end"].one_of(names);
  if (!reason) return reason.error();
  return {EndCheck{*match::parse_end_reason(*reason)}};
}

Parsed parse_golden(const JsonValue& json, const base::Json& golden) {
  if (const auto known = only(json, {"golden"}); !known) return known.error();
  const auto what = json["golden"].one_of({"game_log", "score", "touches"});
  if (!what) return what.error();
  return {GoldenCheck{*what, golden.is_object() ? golden.value(*what, "") : ""}};
}

Parsed parse_what(const JsonValue& json, int steps, const base::Json& golden) {
  if (!json.is_object()) return json.error("must be an object");
  if (json.has("ball")) return parse_step_check(json, steps, {"ball"});
  if (json.has("player")) return parse_step_check(json, steps, {"player", "is"});
  if (json.has("mode")) return parse_step_check(json, steps, {"mode"});
  if (json.has("score")) return parse_score(json);
  if (json.has("referee")) return parse_referee(json);
  if (json.has("touches") || json.has("first_touch") || json.has("last_touch")) {
    return parse_touch(json);
  }
  if (json.has("actions")) return parse_actions(json, steps);
  if (json.has("commands")) return parse_commands(json);
  if (json.has("rpc") || json.has("order")) return parse_rpc(json);
  if (json.has("latency_ms")) return parse_latency(json);
  if (json.has("missed")) return parse_missed(json);
  if (json.has("end")) return parse_end(json);
  if (json.has("golden")) return parse_golden(json, golden);
  const Words kinds = {"ball",        "player",     "mode",    "score",    "referee", "touches",
                       "first_touch", "last_touch", "actions", "commands", "rpc",     "order",
                       "latency_ms",  "missed",     "end",     "golden"};
  for (const std::string& key : json.keys()) {
    const std::string hint = base::did_you_mean(key, kinds);
    if (!hint.empty()) return json.error(fmt::format("unknown kind of check '{}'{}", key, hint));
  }
  return json.error(fmt::format("missing kind of check (known: {})", fmt::join(kinds, ", ")));
}

}  // namespace

Result<soccer::Vec2> parse_point(const JsonValue& json) {
  if (!json.is_array() || json.size() != 2) return json.error("must be [x, y]");
  soccer::Vec2 point;
  for (const auto& [index, member] : {std::pair{0, &point.x}, std::pair{1, &point.y}}) {
    const auto value = json[static_cast<std::size_t>(index)].number(-100, 100);
    if (!value) return value.error();
    *member = *value;
  }
  return point;
}

Result<Side> parse_side(const JsonValue& json) {
  const auto name = json.one_of({"left", "right"});
  if (!name) return name.error();
  return *soccer::parse_side(*name);
}

Result<PlayMode> parse_mode(const JsonValue& json) {
  Words names;
  for (int i = 1; i < soccer::kPlayModeCount; ++i) names.push_back(name(static_cast<PlayMode>(i)));
  const auto name = json.one_of(names);
  if (!name) return name.error();
  return *soccer::parse_play_mode(*name);
}

Result<StepTest> parse_step_test(const JsonValue& json) {
  if (!json.is_object()) return json.error("must be an object");
  const Words kinds = {"mode", "goals", "touch_by", "ball", "player"};
  for (const std::string_view kind : kinds) {
    if (!json.has(kind)) continue;
    const auto known = json.expect_keys(kind == "player" ? Words{"player", "is"} : Words{kind});
    if (!known) return known.error();
    return parse_test(json);
  }
  return json.error(fmt::format("missing condition (known: {})", fmt::join(kinds, ", ")));
}

Result<Check> parse_check(const JsonValue& json, int steps, const base::Json& golden) {
  auto what = parse_what(json, steps, golden);
  if (!what) return what.error();
  Check check;
  check.what = *std::move(what);
  check.line = json.line();
  check.name = json.json().dump();
  if (json.has("name")) {
    const auto text = json["name"].string();
    if (!text) return text.error();
    check.name = *text;
  }
  if (json.has("runs")) {
    const auto runs = Comparison::parse_number(json["runs"]);
    if (!runs) return runs.error();
    check.runs = *runs;
  }
  return check;
}

}  // namespace cls::orchestration::scenario
