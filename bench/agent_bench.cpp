// Cost of an agent's cycle by part over a recorded match, without the call itself and without the
// planner. Each row is the mean over cycles in open play; a cycle's cost is its minimum over some
// replays.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <vector>

#include "base/index.h"
#include "bench/measure.h"
#include "player/movement/home_positions.h"
#include "proto/state_writer.h"
#include "proxy/agent/player_agent.h"
#include "proxy/messages/state_message.h"
#include "soccer/memory_channel.h"
#include "soccer/protocol/message_kind.h"
#include "tests/support/files.h"
#include "tests/support/transcript.h"

namespace cls::bench {
namespace {

/// Returns the microseconds since `last` and sets it to now.
double lap(Clock::time_point& last) {
  const auto now = Clock::now();
  const double us = std::chrono::duration<double, std::micro>(now - last).count();
  last = now;
  return us;
}

enum Part { kParse, kModel, kState, kSerialize, kSkills, kCycle, kParts };
constexpr std::array<const char*, kParts> kNames = {"agent/parse",       "agent/model",
                                                    "agent/state_build", "agent/serialize",
                                                    "agent/skills",      "agent/whole_cycle"};

using Costs = std::array<double, kParts>;  // microseconds

struct Cycles {
  std::vector<Costs> costs;  ///< one per cycle
  double bytes = 0.0;        ///< of all States
};

protos::PlayerActions typical_actions() {
  protos::PlayerActions actions;
  protos::Body_GoToPoint& go = *actions.add_actions()->mutable_body_go_to_point();
  go.mutable_target_point()->set_x(10.0F);
  go.set_distance_threshold(0.5F);
  go.set_max_dash_power(100.0F);
  actions.add_actions()->mutable_neck_turn_to_ball_or_scan();
  return actions;
}

/// Parses the messages of a cycle to measure parsing alone.
class Parser {
 public:
  double parse(const std::string& message) {
    auto last = Clock::now();
    switch (soccer::message_kind(message)) {
      case soccer::MessageKind::kSenseBody:
        benchmark::DoNotOptimize(soccer::parse(message, sense_).ok());
        break;
      case soccer::MessageKind::kSee:
        benchmark::DoNotOptimize(soccer::parse(message, see_).ok());
        break;
      case soccer::MessageKind::kHear:
        benchmark::DoNotOptimize(soccer::parse(message, hear_).ok());
        break;
      default:
        return 0.0;
    }

    return lap(last);
  }

 private:
  soccer::SenseBody sense_;
  soccer::See see_;
  soccer::Hear hear_;
};

/// As the gRPC client does, into existing memory. Sets the number of bytes.
double serialize(const protos::State& state, proto::StateWriter& writer, std::size_t& bytes) {
  auto last = Clock::now();
  bytes = writer.write(state, proto::StateForm::kWhole).size();
  return lap(last);
}

/// Replays a recorded match of one player. The agent processes every message; parsing is repeated
/// to measure it alone.
void replay(const std::vector<tests::Spoken>& transcript, Cycles& cycles) {
  auto [ours, servers] = soccer::make_memory_channel();
  proxy::AgentOptions options;
  options.team_name = "PROXY";
  proxy::PlayerAgent agent(std::move(ours), options);
  const protos::PlayerActions actions = typical_actions();
  Parser parser;
  protos::State state;
  proto::StateWriter writer;
  std::size_t bytes = 0;
  double parsed = 0.0;
  double perceived = 0.0;

  for (const tests::Spoken& spoken : transcript) {
    if (!spoken.by_server) continue;
    servers->send(spoken.message);
    parsed += parser.parse(std::string(spoken.message));
    auto last = Clock::now();
    agent.perceive();
    perceived += lap(last);
    if (!agent.decision_due()) continue;

    const player::WorldModel& world = agent.begin_decision();
    const double completed = lap(last);
    proxy::fill_state(world, player::home_positions(world), false, state);
    const double built = lap(last);
    const double serialized = serialize(state, writer, bytes);
    last = Clock::now();
    agent.act(actions);
    const double acted = lap(last);

    if (state.world_model().game_mode_type() == protos::PlayOn) {
      const double model = perceived + completed;  // includes parsing; subtracted below
      cycles.costs.push_back(
          {parsed, model, built, serialized, acted, model + built + serialized + acted});
      cycles.bytes += static_cast<double>(bytes);
    }
    parsed = perceived = 0.0;
  }
}

/// The minimum cost of each cycle by part. Measured once for all rows.
const Cycles& measured() {
  static const Cycles least = [] {
    constexpr int kReplays = 15;
    Cycles best;
    const auto path = tests::data("aligned/udp/player_l7.txt.gz");
    if (!path) return best;

    const std::string text = tests::read_file(*path);
    const std::vector<tests::Spoken> transcript = tests::read_transcript(text);
    for (int i = 0; i < kReplays; ++i) {
      Cycles cycles;
      replay(transcript, cycles);
      if (i == 0) best = cycles;
      for (std::size_t cycle = 0; cycle < cycles.costs.size(); ++cycle) {
        for (std::size_t part = 0; part < kParts; ++part) {
          best.costs[cycle][part] = std::min(best.costs[cycle][part], cycles.costs[cycle][part]);
        }
      }
    }

    for (Costs& costs : best.costs) costs[kModel] -= costs[kParse];
    return best;
  }();
  return least;
}

void agent(benchmark::State& bench, Part part) {
  const Cycles& cycles = measured();
  if (cycles.costs.empty()) {
    bench.SkipWithError("no recorded logs: set CLS_DATA");
    return;
  }

  std::vector<double> us;
  for (const Costs& costs : cycles.costs) us.push_back(costs[part]);
  std::ranges::sort(us);

  const double count = static_cast<double>(us.size());
  const double mean = std::accumulate(us.begin(), us.end(), 0.0) / count;

  for (auto _ : bench) bench.SetIterationTime(mean * 1e-6);
  bench.counters["p99_us"] = us[static_cast<std::size_t>(0.99 * (count - 1.0))];
  bench.counters["cycles"] = count;
  if (part == kSerialize) bench.counters["state_bytes"] = cycles.bytes / count;
}

const bool registered = [] {
  for (int part = 0; part < kParts; ++part) {
    benchmark::RegisterBenchmark(
        kNames[base::index(part)],
        [part](benchmark::State& bench) { agent(bench, static_cast<Part>(part)); })
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMicrosecond);
  }
  return true;
}();

}  // namespace
}  // namespace cls::bench
