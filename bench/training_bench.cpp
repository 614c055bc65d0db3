// Training pools: world steps per second with random actions, features included, and resets.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "soccer/random.h"
#include "training/c_api/cls_training.h"
#include "training/pool/pool_config.h"

namespace cls::bench {
namespace {

constexpr std::size_t kWorlds = 64;

struct Arena {
  explicit Arena(const std::string& config) {
    const auto parsed = training::parse_pool_config(config);
    const training::Setup& setup = *parsed->setup;
    const std::size_t rows = kWorlds * setup.agent_count();
    columns = setup.value_columns;
    ids.resize(setup.id_count() > 0 ? rows : 0);
    values.resize(rows * columns.size());
    id_count = static_cast<int>(setup.id_count());
    observations.resize(rows * setup.feature_count());
    rewards.resize(rows);
    cls_training_create(config.c_str(), &pool);

    cls_training_buffers buffers = {};
    buffers.struct_size = sizeof buffers;
    buffers.action_ids = {ids.data(), ids.size()};
    buffers.action_values = {values.data(), values.size()};
    buffers.next_seeds = {seeds.data(), kWorlds};
    buffers.observations = {observations.data(), observations.size()};
    buffers.rewards = {rewards.data(), rewards.size()};
    buffers.terminated = {terminated.data(), kWorlds};
    buffers.truncated = {truncated.data(), kWorlds};
    buffers.status = {status.data(), kWorlds};
    cls_training_bind(pool, &buffers);

    draw();
    reset();
  }
  ~Arena() { cls_training_close(pool); }
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  void reset() { cls_training_reset(pool, nullptr, seeds.data(), kWorlds); }

  void draw() {
    for (std::int32_t& id : ids) id = random.integer(id_count);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const training::Column& column = columns[i % columns.size()];
      values[i] = static_cast<float>(
          random.uniform(static_cast<double>(column.low), static_cast<double>(column.high)));
    }
    for (std::uint64_t& seed : seeds) seed = random.next();
  }

  soccer::RandomStream random{1, "training bench"};
  training::Columns columns;
  std::uint64_t pool = 0;
  int id_count = 0;
  std::vector<std::int32_t> ids;
  std::vector<float> values, observations, rewards;
  std::vector<std::uint64_t> seeds = std::vector<std::uint64_t>(kWorlds);
  std::vector<std::uint8_t> terminated = std::vector<std::uint8_t>(kWorlds);
  std::vector<std::uint8_t> truncated = std::vector<std::uint8_t>(kWorlds);
  std::vector<std::int32_t> status = std::vector<std::int32_t>(kWorlds);
};

// All players of both teams are agents.
std::string config(int offense, int defense, int threads, bool world_model) {
  const std::string task = offense == 11 ? "Match" : "HalfFieldOffense";
  return fmt::format(
      R"({{"task": "{}", "features": "ego", "actions": "low", "agents": "{}", "offense": {}, )"
      R"("defense": {}, "num_envs": {}, "threads": {}, "autoreset": "same_step", "obs": "{}"}})",
      task, defense > 0 ? "both" : "offense", offense, defense, kWorlds, threads,
      world_model ? "world_model" : "full_state");
}

void training_step(benchmark::State& bench) {
  Arena arena(config(static_cast<int>(bench.range(0)), static_cast<int>(bench.range(1)),
                     static_cast<int>(bench.range(2)), bench.range(3) != 0));
  for (auto _ : bench) {
    arena.draw();
    cls_training_step(arena.pool);
  }
  bench.SetItemsProcessed(bench.iterations() * static_cast<std::int64_t>(kWorlds));
}
BENCHMARK(training_step)
    ->ArgNames({"offense", "defense", "threads", "world_model"})
    ->Args({1, 0, 1, 0})
    ->Args({1, 0, 2, 0})
    ->Args({1, 1, 1, 0})
    ->Args({2, 2, 1, 0})
    ->Args({2, 2, 2, 0})
    ->Args({5, 5, 1, 0})
    ->Args({11, 11, 1, 0})
    ->Args({1, 0, 1, 1})
    ->Args({2, 2, 1, 1})
    ->Args({2, 2, 2, 1})
    ->Args({11, 11, 1, 1})
    ->UseRealTime()
    ->Unit(benchmark::kMicrosecond);

void training_reset(benchmark::State& bench) {
  Arena arena(config(static_cast<int>(bench.range(0)), static_cast<int>(bench.range(1)), 1,
                     bench.range(2) != 0));
  for (auto _ : bench) arena.reset();
  bench.SetItemsProcessed(bench.iterations() * static_cast<std::int64_t>(kWorlds));
}
BENCHMARK(training_reset)
    ->ArgNames({"offense", "defense", "world_model"})
    ->Args({1, 0, 0})
    ->Args({2, 2, 0})
    ->Args({1, 0, 1})
    ->Args({2, 2, 1})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cls::bench
