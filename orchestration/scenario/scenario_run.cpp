// From a scenario to the record of one run.
#include "orchestration/scenario/scenario_run.h"

#include <chrono>
#include <utility>

#include "gamelog/byte_sink.h"
#include "orchestration/event_log.h"
#include "orchestration/lockstep_match.h"
#include "orchestration/match_chronicle.h"
#include "orchestration/match_options.h"
#include "orchestration/scenario/scenario_director.h"

namespace cls::orchestration {
namespace {

MatchOptions match_options(const Scenario& scenario, const RunSettings& settings) {
  MatchOptions options;
  options.left = scenario.sides[0].playmaker;
  options.right = scenario.sides[1].playmaker;
  if (settings.against && scenario.under_test) {
    (*scenario.under_test == soccer::Side::kLeft ? options.left : options.right) =
        *settings.against;
  }
  options.coach = scenario.coach;
  options.trainer = scenario.trainer;
  options.seed = settings.seed;
  options.server = scenario.server;
  options.player = scenario.player;
  options.rpc_deadline_ms = scenario.rpc_deadline_ms;
  options.max_missed = scenario.max_missed;
  options.on_late = scenario.on_late;
  // Eleven programs, one after the other, on a machine that may be busy.
  constexpr double kTimeToJoin = 60.0;
  const bool guests = !options.left.has_playmaker() || !options.right.has_playmaker();
  if (guests) options.start_timeout_s = kTimeToJoin;
  return options;
}

}  // namespace

soccer::Result<RunRecord> run_scenario(const Scenario& scenario, const RunSettings& settings,
                                       const std::atomic<int>& stop_signal) {
  const auto start = std::chrono::steady_clock::now();
  const MatchOptions options = match_options(scenario, settings);
  const TeamNames names{"left", "right"};
  gamelog::StringSink game_log;
  gamelog::StringSink text_log;
  gamelog::StringSink event_lines;
  EventLog events(event_lines);
  MatchChronicle chronicle(events);
  MatchObserver observer;
  RunRecord record;
  record.seed = settings.seed;
  ScenarioDirector director(scenario, text_log, record);
  auto match = LockstepMatch::create(options, names, settings.seed, stop_signal, settings.host,
                                     settings.folder);
  if (!match) return match.error();
  (*match)->record(game_log, text_log);
  (*match)->direct(director);
  chronicle.begin(names, settings.seed);
  (*match)->play(observer, chronicle);
  director.finish();
  record.result = (*match)->result();
  for (const MatchSide* side : {&(*match)->left(), &(*match)->right()}) {
    for (std::string& line : side->failed_expectations()) {
      record.script_failures.push_back(side->name() + ": " + std::move(line));
    }
  }
  record.game_log = game_log.bytes();
  record.text_log = text_log.bytes();
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return record;
}

}  // namespace cls::orchestration
