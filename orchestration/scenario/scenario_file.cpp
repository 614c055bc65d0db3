// Parses scenario files.
#include "orchestration/scenario/scenario_file.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/text/schema.h"
#include "base/text/stored_formats.h"
#include "mock-server/mock.h"
#include "mock-server/script/named_behaviors.h"
#include "mock-server/script/script.h"
#include "orchestration/match/options/match_options.h"
#include "orchestration/scenario/check_file.h"
#include "soccer/side.h"

namespace cls::orchestration::scenario {
namespace {

using base::Error;
using base::Json;
using base::JsonDocument;
using base::JsonValue;
using base::Result;
using soccer::Side;

constexpr int kMaxSeeds = 1000;
constexpr int kMaxSteps = 100'000;

// Files without a schema are of the first version.
Result<void> check_schema(const JsonValue& json) {
  if (!json.has("schema")) return {};
  const auto schema = json["schema"].string();
  if (!schema) return schema.error();
  if (const auto error = base::schema_error(*schema, base::kScenarioSchema))
    return json["schema"].error(*error);
  return {};
}

Result<void> parse_settings(const JsonValue& json, const char* module,
                            match::MatchOptions& options) {
  if (!json.is_object()) return json.error("must be an object of parameters");
  for (const std::string& key : json.keys()) {
    const JsonValue value = json[key];
    const std::string text = value.is_string() ? *value.string() : value.json().dump();
    const auto set = match::apply_setting(options, fmt::format("{}::{}={}", module, key, text));
    if (!set) return value.error(set.error().message);
  }
  return {};
}

Result<void> parse_server(const JsonValue& json, Scenario& scenario) {
  match::MatchOptions options;
  // Scenarios start without waiting; otherwise the defaults of a match apply.
  options.server.kick_off_wait = 5;
  if (json.has("noise")) {
    const auto noise = json["noise"].boolean();
    if (!noise) return noise.error();
    if (!*noise) {
      options.server.player_rand = options.server.ball_rand = options.server.kick_rand = 0.0;
    }
  }
  for (const char* module : {"server", "player"}) {
    if (!json.has(module)) continue;
    if (const auto set = parse_settings(json[module], module, options); !set) return set;
  }
  scenario.server = options.server;
  scenario.player = options.player;
  return {};
}

Result<void> parse_seeds(const JsonValue& json, Scenario& scenario) {
  if (json.has("seed") && json.has("seeds")) {
    return json["seeds"].error("\"seed\" and \"seeds\" exclude each other");
  }
  if (json.has("seed")) {
    const auto seed = json["seed"].integer(0, 1'000'000'000);
    if (!seed) return seed.error();
    scenario.seeds = {static_cast<std::uint64_t>(*seed)};
  }
  if (json.has("seeds")) {
    const auto count = json["seeds"].integer(1, kMaxSeeds);
    if (!count) return count.error();
    scenario.seeds.clear();
    for (int seed = 1; seed <= *count; ++seed) {
      scenario.seeds.push_back(static_cast<std::uint64_t>(seed));
    }
  }
  return {};
}

Result<StartingPlace> parse_place(const JsonValue& json) {
  if (const auto keys = json.expect_keys({"at", "velocity", "body", "stamina", "cards"}); !keys) {
    return keys.error();
  }
  StartingPlace place;
  if (!json.has("at")) return json.error("requires \"at\": [x, y]");
  for (const auto& [key, member] :
       {std::pair{"at", &place.position}, std::pair{"velocity", &place.velocity}}) {
    if (!json.has(key)) continue;
    const auto point = parse_point(json[key]);
    if (!point) return point.error();
    *member = *point;
  }
  for (const auto& [key, member, high] :
       {std::tuple{"body", &place.body, 180.0}, std::tuple{"stamina", &place.stamina, 100'000.0}}) {
    if (!json.has(key)) continue;
    const auto value = json[key].number(-high, high);
    if (!value) return value.error();
    *member = *value;
  }
  if (json.has("cards")) {
    const auto cards = json["cards"].integer(0, 1);
    if (!cards) return cards.error();
    place.cards = *cards;
  }
  return place;
}

// Reads the files of a side, whose paths start in `folder`.
Result<void> read_files(const JsonValue& json, const std::filesystem::path& folder,
                        match::Endpoint& endpoint) {
  if (!endpoint.planner_file.empty()) {
    endpoint.planner_file = (folder / endpoint.planner_file).string();
  }
  const bool mock = endpoint.kind == match::Endpoint::Kind::kMock;
  if (mock && mock_server::is_script_name(endpoint.behavior)) {
    endpoint.behavior = (folder / endpoint.behavior).string();
  }
  if (const auto loaded = match::load_files(endpoint); !loaded) return loaded;
  if (!mock || endpoint.script != nullptr) return {};
  const auto known = mock_server::make_behavior(endpoint.behavior);
  if (!known) return json.error(known.error().message);
  return {};
}

Result<void> parse_playmaker(const JsonValue& json, match::Endpoint& endpoint) {
  const std::filesystem::path folder = std::filesystem::path(json.text().name()).parent_path();
  if (json.is_object()) {
    const auto script = mock_server::parse_script(json);
    if (!script) return script.error();
    endpoint.text = "mock:(script)";
    endpoint.behavior = "script";
    endpoint.script = *script;
    return {};
  }
  const auto text = json.string();
  if (!text) return text.error();
  auto parsed = match::parse_endpoint(*text);
  if (!parsed) return json.error(parsed.error().message);
  endpoint = *std::move(parsed);
  if (endpoint.kind == match::Endpoint::Kind::kTeam)
    endpoint.path = (folder / endpoint.path).string();
  for (match::Endpoint& part : endpoint.parts) {
    if (auto read = read_files(json, folder, part); !read) return read;
  }
  return read_files(json, folder, endpoint);
}

Result<void> parse_team(const JsonValue& json, ScenarioSide& side) {
  if (const auto keys = json.expect_keys({"playmaker", "players"}); !keys) return keys;
  if (json.has("playmaker")) {
    if (const auto read = parse_playmaker(json["playmaker"], side.playmaker); !read) return read;
  }
  if (!json.has("players")) return {};
  const JsonValue players = json["players"];
  if (!players.is_object()) return players.error("must be an object by uniform number");
  for (const std::string& key : players.keys()) {
    int unum = 0;
    const auto [end, code] = std::from_chars(key.data(), key.data() + key.size(), unum);
    if (code != std::errc{} || end != key.data() + key.size() || unum < 1 ||
        unum > soccer::kPlayersPerTeam) {
      return players[key].error(fmt::format("'{}' is not a uniform number", key));
    }
    const auto place = parse_place(players[key]);
    if (!place) return place.error();
    side.players[unum] = *place;
  }
  return {};
}

Result<void> parse_situation(const JsonValue& json, Scenario& scenario) {
  if (json.has("mode")) {
    const auto mode = parse_mode(json["mode"]);
    if (!mode) return mode.error();
    scenario.mode = *mode;
  }
  if (json.has("cycle")) {
    const auto cycle = json["cycle"].integer(0, kMaxSteps);
    if (!cycle) return cycle.error();
    scenario.cycle = *cycle;
  }
  if (json.has("score")) {
    if (!json["score"].is_array() || json["score"].size() != 2) {
      return json["score"].error("a score is [left, right]");
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const auto goals = json["score"][i].integer(0, 100);
      if (!goals) return goals.error();
      scenario.score[i] = *goals;
    }
  }
  if (!json.has("ball")) return {};
  const JsonValue ball = json["ball"];
  if (const auto keys = ball.expect_keys({"at", "velocity"}); !keys) return keys;
  for (const auto& [key, member] :
       {std::pair{"at", &scenario.ball}, std::pair{"velocity", &scenario.ball_velocity}}) {
    if (!ball.has(key)) continue;
    const auto point = parse_point(ball[key]);
    if (!point) return point.error();
    *member = *point;
  }
  return {};
}

Result<void> parse_sideline(const JsonValue& json, Scenario& scenario) {
  if (json.has("coach")) {
    const auto coach = json["coach"].boolean();
    if (!coach) return coach.error();
    scenario.coach = *coach;
  }
  if (!json.has("trainer")) return {};
  return parse_playmaker(json["trainer"], scenario.trainer.emplace());
}

Result<void> parse_run(const JsonValue& json, Scenario& scenario) {
  for (const auto& [key, member, high] :
       {std::tuple{"steps", &scenario.steps, kMaxSteps},
        std::tuple{"rpc_deadline_ms", &scenario.rpc_deadline_ms, 1'000'000},
        std::tuple{"max_missed", &scenario.max_missed, kMaxSteps}}) {
    if (!json.has(key)) continue;
    const auto value = json[key].integer(1, high);
    if (!value) return value.error();
    *member = *value;
  }
  if (json.has("on_late")) {
    const auto on_late = json["on_late"].one_of({"hold", "last", "default"});
    if (!on_late) return on_late.error();
    scenario.on_late = *on_late == "hold"   ? proxy::OnLate::kHold
                       : *on_late == "last" ? proxy::OnLate::kLast
                                            : proxy::OnLate::kDefault;
  }
  if (!json.has("until")) return {};
  const JsonValue until = json["until"];
  for (std::size_t i = 0; i < (until.is_array() ? until.size() : 1); ++i) {
    const auto test = parse_step_test(until.is_array() ? until[i] : until);
    if (!test) return test.error();
    scenario.until.push_back(*test);
  }
  return {};
}

// Implicit checks, unless a check overrides them: the run finishes, and no decision is missed.
void add_implied_checks(Scenario& scenario, const JsonValue& json) {
  bool says_end = false;
  std::array<bool, 2> says_missed{};
  for (const Check& check : scenario.checks) {
    if (std::holds_alternative<EndCheck>(check.what)) says_end = true;
    if (const auto* missed = std::get_if<MissedCheck>(&check.what)) {
      says_missed[index_of(missed->side)] = true;
    }
  }
  const auto add = [&](auto what, std::string name) {
    Check check;
    check.what = std::move(what);
    check.name = std::move(name);
    check.line = json.line();
    scenario.checks.push_back(std::move(check));
  };
  if (says_end) return;
  add(EndCheck{match::EndReason::kFinished}, "the run finishes");
  const auto zero = JsonDocument::parse("", "0");
  for (const Side side : {Side::kLeft, Side::kRight}) {
    if (says_missed[index_of(side)]) continue;
    add(MissedCheck{side, *mock_server::Comparison::parse_number(JsonValue(*zero))},
        fmt::format("the {} side misses no decision", side_name(side)));
  }
}

Result<void> parse_checks(const JsonValue& json, const Json& golden, Scenario& scenario) {
  if (!json.has("expect")) return json.error("requires \"expect\": a list of checks");
  const JsonValue expect = json["expect"];
  if (!expect.is_array() || expect.size() == 0) return expect.error("must be a list of checks");
  std::size_t rpcs = 0;
  for (std::size_t i = 0; i < expect.size(); ++i) {
    auto check = parse_check(expect[i], scenario.steps, golden);
    if (!check) return check.error();
    if (auto* rpc = std::get_if<RpcCheck>(&check->what)) rpc->index = rpcs++;
    const auto asked = playmaker_of(*check);
    if (asked && !scenario.sides[index_of(*asked)].playmaker.has_playmaker()) {
      return expect[i].error(kExternalTeamHasNoPlaymaker);
    }
    scenario.checks.push_back(*std::move(check));
  }
  add_implied_checks(scenario, expect);
  return {};
}

}  // namespace

Result<Scenario> parse_scenario(const JsonDocument& text, const Json& golden) {
  const JsonValue json(text);
  const auto keys =
      json.expect_keys({"schema",          "about",      "seed",    "seeds",   "noise", "server",
                        "player",          "mode",       "cycle",   "score",   "ball",  "left",
                        "right",           "under_test", "coach",   "trainer", "steps", "until",
                        "rpc_deadline_ms", "max_missed", "on_late", "expect"});
  if (!keys) return keys.error();
  if (const auto checked = check_schema(json); !checked) return checked.error();
  Scenario scenario;
  scenario.file = scenario.argument = text.name();
  scenario.name = std::filesystem::path(text.name()).stem().string();
  scenario.sides[0].playmaker.text = scenario.sides[1].playmaker.text = "mock";
  if (json.has("about")) {
    const auto about = json["about"].string();
    if (!about) return about.error();
    scenario.about = *about;
  }
  for (const auto& parse :
       {parse_seeds, parse_server, parse_situation, parse_sideline, parse_run}) {
    if (const auto parsed = parse(json, scenario); !parsed) return parsed.error();
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const char* key = side_name(side);
    if (!json.has(key)) continue;
    if (const auto read = parse_team(json[key], scenario.sides[index_of(side)]); !read) {
      return read.error();
    }
  }
  if (json.has("under_test")) {
    const auto side = parse_side(json["under_test"]);
    if (!side) return side.error();
    scenario.under_test = *side;
  }
  if (const auto checks = parse_checks(json, golden, scenario); !checks) return checks.error();
  return scenario;
}

}  // namespace cls::orchestration::scenario
