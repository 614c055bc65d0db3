// A decision of a learned policy: the network of examples/training/learn_team.py, from features to
// scores, with weights that are not trained.
#include <benchmark/benchmark.h>

#include <vector>

#include "player/options/option_ids.h"
#include "soccer/random.h"
#include "training/features/feature_set.h"
#include "training/policy/network.h"

namespace cls::bench {
namespace {

using training::Activation;
using training::Network;
using training::StepKind;
using training::StepPlan;

StepPlan dense(int input, int width, Activation activation) {
  return {.kind = StepKind::kDense, .inputs = {input}, .width = width, .activation = activation};
}

// The numbers in the inputs are those of the steps, from 1 on.
Network learned_team() {
  const int features = static_cast<int>(training::kTeamFeatures.columns(10, 11).size());
  const std::vector<StepPlan> steps = {
      {.kind = StepKind::kNorm, .inputs = {0}},
      dense(1, 160, Activation::kRelu),
      dense(2, 64, Activation::kRelu),
      dense(3, 5, Activation::kNone),
      {.kind = StepKind::kColumns, .inputs = {1}, .first = 369, .rows = 16, .width = 8},
      {.kind = StepKind::kConcat, .inputs = {5, 3}},
      dense(6, 48, Activation::kRelu),
      dense(7, 1, Activation::kNone),
      {.kind = StepKind::kFlatten, .inputs = {8}},
      {.kind = StepKind::kColumns, .inputs = {1}, .first = 497, .rows = 10, .width = 32},
      {.kind = StepKind::kColumns, .inputs = {1}, .first = 54, .rows = 10, .width = 15},
      {.kind = StepKind::kConcat, .inputs = {10, 11, 3}},
      dense(12, 64, Activation::kRelu),
      dense(13, 4, Activation::kNone),
      {.kind = StepKind::kFlatten, .inputs = {14}},
      dense(3, 23, Activation::kNone),
      {.kind = StepKind::kConcat, .inputs = {4, 9, 15, 16}}};
  constexpr int kWeights =
      2 * 817 + 818 * 160 + 161 * 64 + 65 * 5 + 73 * 48 + 49 + 112 * 64 + 65 * 4 + 65 * 23;
  soccer::RandomStream random(1, "weights");
  std::vector<float> weights;
  for (int i = 0; i < kWeights; ++i) weights.push_back(static_cast<float>(random.normal(0.0, 0.1)));
  auto network = Network::make(features, steps, weights);
  return network ? *std::move(network) : Network();
}

void BM_PolicyNetwork(benchmark::State& state) {
  const Network network = learned_team();
  if (network.scores() != player::kOptionCount) return state.SkipWithError("does not fit");
  Network::Workspace workspace;
  const std::vector<float> features(static_cast<std::size_t>(network.features()), 0.3F);
  for (auto _ : state) {
    benchmark::DoNotOptimize(network.run(features.data(), nullptr, workspace));
  }
}
BENCHMARK(BM_PolicyNetwork)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cls::bench
