// Cost of a plan in each cycle of a recorded match in which the player is near the ball.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bench/measure.h"
#include "player/planner/field.h"
#include "player/planner/planner.h"
#include "proxy/agent/player_agent.h"
#include "soccer/memory_channel.h"
#include "tests/support/files.h"
#include "tests/support/transcript.h"

namespace cls::bench {
namespace {

/// All kinds of actions, as upstream's samples request.
player::PlannerOptions all_kinds() {
  player::PlannerOptions options;
  options.simple_pass = options.simple_dribble = true;
  return options;
}

/// Appends the microseconds of each plan. To get many plans, moves the ball to a player within 10 m
/// of it; opponents and teammates stay where the world model has them.
void plans_of(const std::string& file, std::vector<double>& times, std::size_t& nodes) {
  const auto path = tests::data(file);
  if (!path) return;
  auto [ours, servers] = soccer::make_memory_channel();
  proxy::AgentOptions options;
  options.team_name = "PROXY";
  proxy::PlayerAgent agent(std::move(ours), options);
  const protos::PlayerActions no_actions;
  const std::string text = tests::read_file(*path);  // the lines refer to it

  for (const tests::Spoken& spoken : tests::read_transcript(text)) {
    if (!spoken.by_server) continue;
    servers->send(spoken.message);
    agent.perceive();
    if (!agent.decision_due()) continue;
    agent.state();
    player::WorldModel world = agent.world();
    agent.act(no_actions);

    if (world.game.mode != soccer::PlayMode::kPlayOn || world.ball.dist_from_self > 10.0) continue;
    world.ball.position = world.self.position + soccer::polar(0.6, world.self.body);
    world.ball.velocity = world.self.velocity;
    world.self.kickable = true;
    world.self.kick_rate = 0.024;

    const auto before = Clock::now();
    const player::PlannerField field(world);
    const player::Plan plan = player::make_plan(field, all_kinds());
    times.push_back(seconds_since(before) * 1e6);
    nodes += plan.nodes.size();
  }
}

void plan(benchmark::State& bench) {
  std::vector<double> times;
  std::size_t nodes = 0;
  for (auto _ : bench) {
    for (const char* file : {"aligned/udp/player_l4.txt.gz", "aligned/udp/player_l7.txt.gz",
                             "aligned/udp/player_l10.txt.gz"}) {
      plans_of(file, times, nodes);
    }
  }
  if (times.empty()) {
    bench.SkipWithError("no recorded logs: set CLS_DATA");
    return;
  }

  std::ranges::sort(times);
  const auto quantile = [&](double part) {
    return times[static_cast<std::size_t>(part * static_cast<double>(times.size() - 1))];
  };

  bench.counters["plans"] = static_cast<double>(times.size());
  bench.counters["nodes"] = static_cast<double>(nodes) / static_cast<double>(times.size());
  bench.counters["p50_us"] = quantile(0.5);
  bench.counters["p99_us"] = quantile(0.99);
  bench.counters["max_us"] = times.back();
}
BENCHMARK(plan)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace cls::bench
