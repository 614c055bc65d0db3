// One check per kind of file.
#include "tests/fuzz/user_file_checks.h"

#include <google/protobuf/stubs/logging.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "base/text/json_document.h"
#include "mock-server/script/script.h"
#include "orchestration/match/options/planner_file.h"
#include "orchestration/scenario/scenario_file.h"
#include "orchestration/tournament/config/config.h"
#include "orchestration/tournament/config/config_file.h"
#include "orchestration/tournament/schedule/schedule.h"
#include "orchestration/tournament/schedule/schedule_check.h"
#include "proto/playmaker.pb.h"
#include "proxy/formation/formation_file.h"
#include "proxy/formation/librcsc_formation.h"
#include "proxy/world/planner_parameters.h"

namespace cls::tests {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void check_scenario(const std::string& text) {
  const auto document = base::JsonDocument::parse("scenario.json", text);
  if (!document) return;
  const auto scenario = orchestration::scenario::parse_scenario(*document, base::Json());
  require(scenario.ok() || !scenario.error().message.empty());
}

void check_script(const std::string& text) {
  const auto document = base::JsonDocument::parse("script.json", text);
  if (!document) return;
  // Files that it names are not those of the fuzzer.
  if (text.find("replay:") != std::string::npos) return;
  const auto script = mock_server::parse_script(base::JsonValue(*document));
  if (!script) return;
  const mock_server::ScriptedBehavior behavior(*script);
  protos::State state;
  state.mutable_world_model()->set_cycle(1);
  protos::PlayerActions player;
  protos::CoachActions coach;
  protos::TrainerActions trainer;
  behavior.decide(state, player);
  behavior.decide_as_coach(state, coach);
  behavior.decide_as_trainer(state, trainer);
}

void check_formation(const std::string& text) {
  const auto formation = proxy::parse_formation(text, "fuzz");
  if (!formation) return;
  const std::string written = proxy::format_formation(*formation);
  const auto again = proxy::parse_formation(written, "fuzz");
  require(again.ok());
  require(proxy::format_formation(*again) == written);
}

void check_config(const std::string& text) {
  using namespace orchestration::tournament;
  const ParsedConfig parsed = parse_config(text, "cls.toml");
  if (!parsed.errors.empty() || !validate(parsed.config).empty()) return;
  const ParsedConfig again = parse_config(format_config(parsed.config), "cls.toml");
  require(again.errors.empty());
  require(first_difference(parsed.config, again.config).empty());
  constexpr std::size_t kFewTeams = 16;
  constexpr int kFewRounds = 20;
  if (parsed.config.teams.size() > kFewTeams || rounds_of(parsed.config) > kFewRounds) return;
  for (const Fixture& fixture : next_fixtures(parsed.config, {})) {
    require(check_teams(parsed.config, fixture).ok());
  }
}

void check_planner_file(const std::string& text) {
  const auto parameters = orchestration::match::parse_planner_file(text, "planner.toml");
  if (!parameters) return require(!parameters.error().message.empty());
  for (const proxy::PlannerParameter& row : proxy::planner_parameter_table()) {
    const double value = value_of(**parameters, row);
    require(value >= row.low && value <= row.high);
  }
}

}  // namespace

void check_user_file(std::string_view input) {
  google::protobuf::LogSilencer no_complaints;
  if (input.empty()) return;
  const std::string text(input.substr(1));
  switch (input.front()) {
    case 's':
      return check_scenario(text);
    case 'm':
      return check_script(text);
    case 'f':
      return check_formation(text);
    case 'l':
      proxy::parse_librcsc_formation(text, "fuzz").ok();
      return;
    case 't':
      return check_config(text);
    case 'p':
      return check_planner_file(text);
    default:
      return;
  }
}

}  // namespace cls::tests
