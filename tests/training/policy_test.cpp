// Policy files and their networks.
#include "training/policy/policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "base/index.h"
#include "soccer/math.h"
#include "tests/support/files.h"
#include "training/policy/policy_player.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using training::Network;
using training::StepKind;
using training::StepPlan;

constexpr int kRows = 3;

std::string bytes_of(const std::string& name) { return read_file(fixture("policies/" + name)); }

// python/tests/gym_network_test.py has the same numbers.
std::vector<float> observation(int row, int width) {
  std::vector<float> all;
  for (int i = row * width; i < (row + 1) * width; ++i) {
    all.push_back(static_cast<float>(i * 37 % 101 - 50) / 50.0F);
  }
  return all;
}

TEST(PolicyNetwork, HasTheBitsOfPython) {
  const auto policy = training::parse_policy(bytes_of("all_kinds.policy"), "all_kinds.policy");
  ASSERT_TRUE(policy) << policy.error().message;
  const Network& network = policy->network;
  ASSERT_EQ(network.scores(), player::kOptionCount);
  ASSERT_EQ(network.memory(), 9);

  Network::Workspace workspace;
  std::vector<float> memory(base::index(network.memory()));
  std::string scores;
  for (int row = 0; row < kRows; ++row) {
    const std::vector<float> seen = observation(row, network.features());
    const float* out = network.run(seen.data(), memory.data(), workspace);
    scores.append(reinterpret_cast<const char*>(out), sizeof(float) * player::kOptionCount);
  }
  EXPECT_TRUE(scores == bytes_of("all_kinds.scores"));
}

TEST(PolicyNetwork, TanhIsNearTheExactOne) {
  for (double x = -10.0; x <= 10.0; x += 0.01) {
    const double e = soccer::math::exp(2.0 * x);
    const double exact = (e - 1.0) / (e + 1.0);
    EXPECT_NEAR(static_cast<double>(training::portable_tanh(static_cast<float>(x))), exact, 5e-7);
  }
}

std::string error_of(const std::vector<StepPlan>& steps, std::size_t weights) {
  const auto network = Network::make(6, steps, std::vector<float>(weights, 0.5F));
  return network ? "" : network.error().message;
}

TEST(PolicyNetwork, RefusesStepsThatDoNotFit) {
  const StepPlan dense = {.kind = StepKind::kDense, .inputs = {0}, .width = 2};
  EXPECT_EQ(error_of({dense}, 14), "");
  EXPECT_EQ(error_of({dense}, 13), "step 1: has fewer weights than it needs");
  EXPECT_EQ(error_of({dense}, 15), "has more weights than its steps need");
  EXPECT_EQ(error_of({}, 0), "must have 1 to 100 steps");
  EXPECT_EQ(error_of({{.kind = StepKind::kDense, .inputs = {0}}}, 0),
            "step 1: its size is out of range");
  EXPECT_EQ(error_of({{.kind = StepKind::kFlatten, .inputs = {1}}}, 0),
            "step 1: an input does not exist");
  EXPECT_EQ(
      error_of({{.kind = StepKind::kColumns, .inputs = {0}, .first = 1, .rows = 2, .width = 3}}, 0),
      "step 1: its input has fewer columns");
  EXPECT_EQ(error_of({{.kind = StepKind::kPool, .inputs = {0}}}, 0),
            "step 1: has another number of inputs");
  EXPECT_EQ(error_of({{.kind = StepKind::kDense, .inputs = {0}, .width = 70000}}, 500000),
            "step 1: its size is out of range");
  const auto infinite = Network::make(6, {dense}, std::vector<float>(14, HUGE_VALF));
  EXPECT_EQ(infinite.error().message, "a weight is not a finite number");
}

TEST(PolicyNetwork, PoolsTheRowsThatAreThere) {
  const auto network =
      Network::make(6,
                    {{.kind = StepKind::kColumns, .inputs = {0}, .rows = 3, .width = 2},
                     {.kind = StepKind::kPool, .inputs = {1, 1}}},
                    {});
  ASSERT_TRUE(network);
  Network::Workspace workspace;
  const auto pooled = [&](std::vector<float> seen) {
    const float* out = network->run(seen.data(), nullptr, workspace);
    return std::vector<float>(out, out + 4);
  };
  EXPECT_THAT(pooled({1, -4, 0, 9, 3, -2}), testing::ElementsAre(2, -3, 3, -2));
  EXPECT_THAT(pooled({0, -4, 0, 9, -1, 2}), testing::ElementsAre(0, 0, 0, 0));
}

TEST(PolicyFile, SaysWhatIsWrong) {
  const std::string good = bytes_of("all_kinds.policy");
  const auto error = [](const std::string& bytes) {
    const auto policy = training::parse_policy(bytes, "x.policy");
    return policy ? std::string() : policy.error().message;
  };
  const auto with = [&good](std::string_view text, std::string_view other) {
    std::string changed = good;
    EXPECT_EQ(text.size(), other.size());
    return changed.replace(good.find(text), text.size(), other);
  };

  EXPECT_EQ(error(good), "");
  EXPECT_EQ(error("PK"), "x.policy: is not a file of cls.policy/2");
  EXPECT_EQ(error(good.substr(0, 100)), "x.policy: is cut off");
  EXPECT_THAT(error(good.substr(0, good.size() - 4)), HasSubstr("fewer weights"));
  EXPECT_THAT(error(good.substr(0, good.size() - 1)), HasSubstr("is cut off"));
  EXPECT_THAT(error(good + "1234"), HasSubstr("more weights"));
  EXPECT_THAT(error(with("cls.policy/2", "cls.policy/3")), HasSubstr("schema is not cls.policy/2"));
  EXPECT_THAT(error(with("\"options\"", "\"actions\"")), HasSubstr("needs the actions options/1"));
  EXPECT_THAT(error(with("\"team\"", "\"tram\"")), HasSubstr("tram/1 cannot be observed"));
  EXPECT_THAT(error(with("world_model", "world_madel")), HasSubstr("obs world_model"));
  EXPECT_THAT(error(with("\"gru\"", "\"gro\"")), HasSubstr("did you mean 'gru'?"));
  EXPECT_THAT(error(with("\"ball\"", "\"bill\"")), HasSubstr("did you mean 'ball'?"));
}

TEST(PolicyFile, BuiltInPoliciesNeedNoFile) {
  EXPECT_EQ((*training::read_policy("planner"))->kind, training::PolicyKind::kPlanner);
  EXPECT_EQ((*training::read_policy("random"))->kind, training::PolicyKind::kRandom);
  const auto missing = training::read_policy("no.policy");
  EXPECT_EQ(missing.error().message, "no.policy: no such file");
}

TEST(PolicyPlayer, TakesTheBestLegalOption) {
  player::OptionTable table;
  std::vector<float> scores(player::kOptionCount, 0.0F);
  scores[player::kAutoOption] = 9.0F;
  scores[7] = 3.0F;
  scores[9] = 5.0F;
  table.legal[player::kAutoOption] = true;
  EXPECT_EQ(training::best_option(table, scores.data()), player::kAutoOption);
  table.legal[6] = table.legal[7] = true;
  EXPECT_EQ(training::best_option(table, scores.data()), 7);
}

TEST(PolicyPlayer, WeighsTheLegalOptions) {
  const player::WorldModel world;
  player::OptionTable table;
  table.choice = player::OptionTable::Choice::kWithBall;
  table.legal[player::kHoldOption] = table.legal[player::kClearOption] = table.legal[7] = true;
  table.targets.push_back({7, {.target_point = {3.0, 4.0}}, 2.5});
  std::vector<float> scores(player::kOptionCount, 50.0F);
  scores[player::kHoldOption] = scores[player::kClearOption] = -200.0F;
  scores[7] = -199.0F;

  const auto weighed = training::weigh_options(world, table, scores.data(), 7);
  ASSERT_EQ(weighed.size(), 3U) << "what is not legal has no share";
  EXPECT_EQ(weighed[0].id, player::kHoldOption);
  EXPECT_EQ(weighed[2].id, 7);
  EXPECT_TRUE(weighed[2].chosen && !weighed[0].chosen && !weighed[1].chosen);
  EXPECT_NEAR(weighed[2].share, 0.57612, 1e-5);  // e / (e + 2)
  EXPECT_NEAR(weighed[0].share, 0.21194, 1e-5);
  EXPECT_EQ(weighed[2].aim.target, (soccer::Vec2{3.0, 4.0}));
  EXPECT_EQ(weighed[2].aim.room, 2.5);
  EXPECT_FALSE(weighed[1].aim.target);

  scores[7] = std::numeric_limits<float>::infinity();
  const auto infinite = training::weigh_options(world, table, scores.data(), 7);
  EXPECT_EQ(infinite[2].share, 1.0);
  EXPECT_EQ(infinite[0].share, 0.0);
}

}  // namespace
}  // namespace cls::tests
