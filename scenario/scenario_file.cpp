// Parses scenario files.
#include "scenario/scenario_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/text/json.h"
#include "base/text/number_text.h"
#include "base/text/schema.h"
#include "base/text/stored_formats.h"
#include "match/terms/match_options.h"
#include "match/terms/option_table.h"
#include "mock-server/mock.h"
#include "mock-server/script/named_behaviors.h"
#include "mock-server/script/script.h"
#include "scenario/check_file.h"
#include "soccer/side.h"

namespace cls::scenario {
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
  TRY_INIT(const auto schema, json["schema"].string());
  if (const auto error = base::schema_error(schema, base::kScenarioSchema))
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
    TRY_INIT(const auto noise, json["noise"].boolean());
    if (!noise) {
      options.server.player_rand = options.server.ball_rand = options.server.kick_rand = 0.0;
    }
  }

  for (const char* module : {"server", "player"}) {
    if (!json.has(module)) continue;
    TRY(parse_settings(json[module], module, options));
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
    TRY_INIT(const auto seed, json["seed"].integer(0, 1'000'000'000));
    scenario.seeds = {static_cast<std::uint64_t>(seed)};
  }

  if (json.has("seeds")) {
    TRY_INIT(const auto count, json["seeds"].integer(1, kMaxSeeds));
    scenario.seeds.clear();
    for (int seed = 1; seed <= count; ++seed) {
      scenario.seeds.push_back(static_cast<std::uint64_t>(seed));
    }
  }

  return {};
}

Result<StartingPlace> parse_place(const JsonValue& json) {
  TRY(json.expect_keys({"at", "velocity", "body", "stamina", "cards"}));
  StartingPlace place;
  if (!json.has("at")) return json.error("requires \"at\": [x, y]");
  for (const auto& [key, member] :
       {std::pair{"at", &place.position}, std::pair{"velocity", &place.velocity}}) {
    TRY(parse_if(json, key, parse_point, *member));
  }

  for (const auto& [key, member, high] :
       {std::tuple{"body", &place.body, 180.0}, std::tuple{"stamina", &place.stamina, 100'000.0}}) {
    if (!json.has(key)) continue;
    TRY_INIT(*member, json[key].number(-high, high));
  }
  TRY(parse_if(json, "cards", integer(0, 1), place.cards));
  return place;
}

// Reads the files of a side, whose paths start in `folder`.
Result<void> read_files(const JsonValue& json, const std::filesystem::path& folder,
                        match::Endpoint& endpoint) {
  if (!endpoint.planner_file.empty()) {
    endpoint.planner_file = (folder / endpoint.planner_file).string();
  }
  if (endpoint.has_policy_file()) {
    endpoint.policy_file = (folder / endpoint.policy_file).string();
  }
  const bool mock = endpoint.kind == match::Endpoint::Kind::kMock;
  if (mock && mock_server::is_script_name(endpoint.behavior)) {
    endpoint.behavior = (folder / endpoint.behavior).string();
  }
  TRY(match::load_files(endpoint));
  if (!mock || endpoint.script != nullptr) return {};
  const auto known = mock_server::make_behavior(endpoint.behavior);
  if (!known) return json.error(known.error().message);

  return {};
}

Result<void> parse_playmaker(const JsonValue& json, const ResolveSide& resolve,
                             match::Endpoint& endpoint) {
  if (json.is_object()) {
    TRY_INIT(const auto script, mock_server::parse_script(json));
    endpoint.text = "mock:(script)";
    endpoint.behavior = "script";
    endpoint.script = script;
    return {};
  }

  TRY_INIT(const auto text, json.string());
  std::filesystem::path folder = std::filesystem::path(json.text().name()).parent_path();
  const auto side = resolve ? resolve(text, folder) : Result<std::string>(text);
  if (!side) return json.error(side.error().message);
  if (*side != text) folder.clear();  // the paths of a team are those of the working directory

  auto parsed = match::parse_endpoint(*side);
  if (!parsed) return json.error(parsed.error().message);
  endpoint = *std::move(parsed);
  if (endpoint.kind == match::Endpoint::Kind::kTeam) {
    if (endpoint.parts.empty()) endpoint.path = (folder / endpoint.path).string();
    for (match::Endpoint& part : endpoint.parts) part.path = (folder / part.path).string();
  }
  for (match::Endpoint& part : endpoint.parts) {
    TRY(read_files(json, folder, part));
  }
  return read_files(json, folder, endpoint);
}

Result<void> parse_team(const JsonValue& json, const ResolveSide& resolve, ScenarioSide& side) {
  TRY(json.expect_keys({"playmaker", "players"}));
  if (json.has("playmaker")) {
    TRY(parse_playmaker(json["playmaker"], resolve, side.playmaker));
  }
  if (!json.has("players")) return {};
  const JsonValue players = json["players"];
  if (!players.is_object()) return players.error("must be an object by uniform number");

  for (const std::string& key : players.keys()) {
    const int unum = base::parse_int(key).value_or(0);
    if (!soccer::is_unum(unum)) {
      return players[key].error(fmt::format("'{}' is not a uniform number", key));
    }
    TRY_INIT(side.players[unum], parse_place(players[key]));
  }

  return {};
}

Result<void> parse_situation(const JsonValue& json, Scenario& scenario) {
  TRY(parse_if(json, "mode", parse_mode, scenario.mode));
  TRY(parse_if(json, "cycle", integer(0, kMaxSteps), scenario.cycle));

  if (json.has("score")) {
    if (!json["score"].is_array() || json["score"].size() != 2) {
      return json["score"].error("a score is [left, right]");
    }
    for (std::size_t i = 0; i < 2; ++i) {
      TRY_INIT(scenario.score[i], json["score"][i].integer(0, 100));
    }
  }
  if (!json.has("ball")) return {};
  const JsonValue ball = json["ball"];
  TRY(ball.expect_keys({"at", "velocity"}));
  for (const auto& [key, member] :
       {std::pair{"at", &scenario.ball}, std::pair{"velocity", &scenario.ball_velocity}}) {
    TRY(parse_if(ball, key, parse_point, *member));
  }

  return {};
}

// The text of a value for an option of a match.
Result<std::string> option_text(const match::MatchOption& option, const JsonValue& json) {
  const std::string written = json.is_string() ? *json.string() : json.json().dump();
  const bool is_text = option.form.kind == base::ValueKind::kText;
  if (is_text != json.is_string() || !base::fits(option.form, written)) {
    return json.error("must be " + base::phrase_of(option.form));
  }
  return written;
}

Result<void> parse_options(const JsonValue& json, Scenario& scenario) {
  for (const match::MatchOption& option : match::match_options()) {
    const std::string key(option.scenario_key);
    if (key.empty() || !json.has(key)) continue;
    TRY_INIT(auto text, option_text(option, json[key]));
    scenario.options[std::string(option.key)] = std::move(text);
  }
  return {};
}

Result<void> parse_run(const JsonValue& json, Scenario& scenario) {
  TRY(parse_if(json, "steps", integer(1, kMaxSteps), scenario.steps));
  if (!json.has("until")) return {};
  for (const JsonValue& each : elements_of(json["until"])) {
    TRY_INIT(auto test, parse_step_test(each));
    scenario.until.push_back(std::move(test));
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
    TRY_INIT(auto check, parse_check(expect[i], scenario.steps, golden));
    if (auto* rpc = std::get_if<RpcCheck>(&check.what)) rpc->index = rpcs++;
    const auto asked = playmaker_of(check);
    if (asked && !scenario.sides[index_of(*asked)].playmaker.has_playmaker()) {
      return expect[i].error(kExternalTeamHasNoPlaymaker);
    }
    scenario.checks.push_back(std::move(check));
  }

  add_implied_checks(scenario, expect);
  return {};
}

std::vector<std::string_view> scenario_keys() {
  std::vector<std::string_view> keys = {
      "schema", "about", "seed", "seeds", "noise",      "server",  "player", "mode",  "cycle",
      "score",  "ball",  "left", "right", "under_test", "trainer", "steps",  "until", "expect"};
  for (const match::MatchOption& option : match::match_options()) {
    if (!option.scenario_key.empty()) keys.push_back(option.scenario_key);
  }
  return keys;
}

}  // namespace

Result<Scenario> parse_scenario(const JsonDocument& text, const Json& golden,
                                const ResolveSide& resolve) {
  const JsonValue json(text);
  TRY(json.expect_keys(scenario_keys()));
  TRY(check_schema(json));
  Scenario scenario;
  scenario.file = scenario.argument = text.name();
  scenario.name = std::filesystem::path(text.name()).stem().string();
  scenario.sides[0].playmaker.text = scenario.sides[1].playmaker.text = "mock";
  TRY(parse_if(json, "about", text_in, scenario.about));
  for (const auto& parse : {parse_seeds, parse_server, parse_situation, parse_options, parse_run}) {
    TRY(parse(json, scenario));
  }

  for (const Side side : {Side::kLeft, Side::kRight}) {
    const char* key = side_name(side);
    if (!json.has(key)) continue;
    TRY(parse_team(json[key], resolve, scenario.sides[index_of(side)]));
  }

  if (json.has("trainer")) {
    TRY(parse_playmaker(json["trainer"], resolve, scenario.trainer.emplace()));
  }
  TRY(parse_if(json, "under_test", parse_side, scenario.under_test));
  TRY(parse_checks(json, golden, scenario));
  return scenario;
}

}  // namespace cls::scenario
