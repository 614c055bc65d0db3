// Plays one run of a scenario.
#include "scenario/scenario_run.h"

#include <chrono>
#include <string>
#include <utility>

#include "base/io/byte_sink.h"
#include "match/match_setup.h"
#include "match/programs/team_sandbox.h"
#include "match/terms/match_options.h"
#include "match/terms/option_table.h"
#include "scenario/scenario_recorder.h"
#include "soccer/per_side.h"

namespace cls::scenario {
namespace {

match::MatchOptions match_options(const Scenario& scenario, const RunSettings& settings) {
  match::MatchOptions options;
  options.left = scenario.sides[0].playmaker;
  options.right = scenario.sides[1].playmaker;
  if (settings.against && scenario.under_test) {
    (*scenario.under_test == soccer::Side::kLeft ? options.left : options.right) =
        *settings.against;
  }

  static_cast<void>(match::set_options(options, scenario.options));  // checked when read
  options.trainer = scenario.trainer;
  options.seed = settings.seed;
  options.server = scenario.server;
  options.player = scenario.player;
  options.sandbox = settings.sandbox;
  options.sandbox_playmakers = settings.sandbox_playmakers;

  // A team starts 11 programs in sequence, possibly on a busy host.
  constexpr double kTimeToJoin = 60.0;
  const bool external = !options.left.has_playmaker() || !options.right.has_playmaker();
  if (external) options.start_timeout_s = kTimeToJoin;
  if (settings.start_timeout_s) options.start_timeout_s = *settings.start_timeout_s;
  return options;
}

}  // namespace

base::Result<RunRecord> run_scenario(const Scenario& scenario, const RunSettings& settings,
                                     const std::atomic<int>& stop_signal) {
  const auto start = std::chrono::steady_clock::now();
  const match::MatchOptions options = match_options(scenario, settings);
  if (std::string why = match::refused_without_namespaces(options); !why.empty()) {
    return base::Error{std::move(why)};
  }
  const match::TeamNames names{"left", "right"};
  base::StringSink game_log;
  base::StringSink text_log;
  match::MatchObserver observer;
  RunRecord record;
  record.seed = settings.seed;
  ScenarioRecorder director(scenario, text_log, record);
  TRY_INIT(auto match, match::make_lockstep_match({options, names, settings.seed, stop_signal,
                                                   settings.host, settings.folder},
                                                  {&game_log, &text_log}));

  match->add_hooks(director);
  match->play(observer);
  director.finish();
  record.result = match->result();
  for (const auto& side : match->sides()) {
    if (side->identity().side == soccer::Side::kNeutral) continue;
    if (const proxy::PlaymakerErrors* errors = side->errors(); errors != nullptr) {
      record.errors.at(soccer::side_index(side->identity().side)) = errors->first;
    }
    for (const std::string& line : side->failed_expectations()) {
      record.script_failures.push_back(side->identity().name + ": " + line);
    }
  }

  record.game_log = game_log.bytes();
  record.text_log = text_log.bytes();
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  return record;
}

}  // namespace cls::scenario
