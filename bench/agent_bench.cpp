// What an agent's own turn costs: parsing, world model, State, skills; all but the call itself.
#include <benchmark/benchmark.h>

#include <chrono>
#include <string>
#include <vector>

#include "proxy/home_positions.h"
#include "proxy/player_agent.h"
#include "proxy/state_message.h"
#include "soccer/memory_channel.h"
#include "tests/support/files.h"
#include "tests/support/transcript.h"

namespace cls::bench {
namespace {

using Clock = std::chrono::steady_clock;

double us_since(Clock::time_point& last) {
  const auto now = Clock::now();
  const double us = std::chrono::duration<double, std::micro>(now - last).count();
  last = now;
  return us;
}

struct Costs {
  double perceive = 0.0;
  double state = 0.0;  ///< completing the world, home positions, State
  double fill = 0.0;   ///< the State alone
  double act = 0.0;
  int turns = 0;  ///< in play_on, where everything is in use
  double bytes = 0.0;
};

protos::PlayerActions usual_actions() {
  protos::PlayerActions actions;
  protos::Body_GoToPoint& go = *actions.add_actions()->mutable_body_go_to_point();
  go.mutable_target_point()->set_x(10.0F);
  go.set_distance_threshold(0.5F);
  go.set_max_dash_power(100.0F);
  actions.add_actions()->mutable_neck_turn_to_ball_or_scan();
  return actions;
}

/// A whole recorded match of one player.
void replay(const std::vector<tests::Spoken>& transcript, Costs& costs) {
  auto [ours, servers] = soccer::make_memory_channel();
  proxy::AgentOptions options;
  options.team_name = "PROXY";
  proxy::PlayerAgent agent(std::move(ours), options);
  const protos::PlayerActions actions = usual_actions();
  protos::State again;
  double perceive = 0.0;
  for (const tests::Spoken& spoken : transcript) {
    if (!spoken.by_server) continue;
    servers->send(spoken.message);
    auto last = Clock::now();
    agent.perceive();
    perceive += us_since(last);
    if (!agent.decision_due()) continue;
    const protos::State& state = agent.state();
    const double completed = us_since(last);
    const proxy::HomePositions home = proxy::home_positions(agent.world());
    last = Clock::now();
    proxy::fill_state(agent.world(), home, false, again);
    const double filled = us_since(last);
    agent.act(actions);
    if (state.world_model().game_mode_type() == protos::PlayOn) {
      costs.act += us_since(last);
      costs.perceive += perceive;
      costs.state += completed;
      costs.fill += filled;
      costs.bytes += static_cast<double>(state.ByteSizeLong());
      ++costs.turns;
    }
    perceive = 0.0;
  }
}

void agent_turn(benchmark::State& bench) {
  const auto path = tests::data("aligned/udp/player_l7.txt.gz");
  if (!path) {
    bench.SkipWithError("no data: set CLS_DATA");
    return;
  }
  const std::string text = tests::read_file(*path);
  const std::vector<tests::Spoken> transcript = tests::read_transcript(text);
  Costs costs;
  for (auto _ : bench) replay(transcript, costs);
  const auto per_turn = [&](double sum) { return sum / costs.turns; };
  bench.counters["perceive_us"] = per_turn(costs.perceive);
  bench.counters["state_us"] = per_turn(costs.state);
  bench.counters["of_which_fill_us"] = per_turn(costs.fill);
  bench.counters["act_us"] = per_turn(costs.act);
  bench.counters["state_bytes"] = per_turn(costs.bytes);
}
BENCHMARK(agent_turn)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cls::bench
