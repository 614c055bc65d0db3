// Rows for Playmakers are the observations of training, to the bit.
#include "match/sides/policy_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <utility>

#include "base/index.h"
#include "training/episode/episode.h"
#include "training/pool/pool_config.h"

namespace cls::match {
namespace {

using training::Episode;
using training::Setup;

std::shared_ptr<const Setup> setup_of(const char* config) {
  auto parsed = training::parse_pool_config(config);
  if (!parsed) throw std::runtime_error(parsed.error().message);
  return parsed->setup;
}

/// Plays with one action for all agents.
void play(Episode& episode, const Setup& setup, int cycles, std::int32_t id) {
  const std::vector<std::int32_t> ids(setup.agent_count(), id);
  const std::vector<float> values(setup.agent_count() * setup.value_count(), 0.5F);
  for (int i = 0; i < cycles; ++i) episode.step({ids.data(), values.data()}, nullptr);
}

constexpr std::int32_t kIntercept = 7;

/// A match at its begin.
struct Begun {
  explicit Begun(
      const char* config = R"({"task": "Match", "agents": "both", "obs": "world_model"})")
      : setup(setup_of(config)), episode(setup) {
    episode.reset(3, setup->options);
  }

  std::shared_ptr<const Setup> setup;
  Episode episode;
};

TEST(PolicyRows, AreTheObservationsOfTraining) {
  for (const char* features : {"ego", "hfo_high"}) {
    Begun begun(fmt::format(R"({{"task": "Match", "agents": "both", "actions": "hfo",
                               "features": "{}", "obs": "world_model"}})",
                            features)
                    .c_str());
    const auto setup = begun.setup;
    Episode& episode = begun.episode;
    const auto codec = make_policy_rows();
    const auto sizes = codec->choose({fmt::format("{}/1", features), "hfo/2", 10, 11});
    ASSERT_TRUE(sizes) << sizes.error().message;
    ASSERT_EQ(sizes->features, static_cast<int>(setup->feature_count()));
    EXPECT_EQ(sizes->ids, 20);
    EXPECT_EQ(sizes->actions, 16);

    for (int round = 0; round < 5; ++round) {
      play(episode, *setup, 15, kIntercept);
      std::vector<float> all(setup->agent_count() * setup->feature_count());
      episode.observe(all.data());

      for (std::size_t agent = 0; agent < setup->agent_count(); ++agent) {
        std::vector<float> row;
        std::vector<std::uint8_t> mask;
        codec->encode(*episode.world_model(agent), row, mask);
        const float* observed = all.data() + agent * setup->feature_count();
        std::vector<std::uint8_t> legal(setup->id_count());
        episode.mask(agent, legal.data());
        EXPECT_EQ(mask, legal);

        for (std::size_t i = 0; i < row.size(); ++i) {
          const std::string& name = setup->feature_columns[i].name;
          // Columns of the episode and of its last action: a match has neither.
          if (name == "time_left" || name == "last_action_worked") continue;
          EXPECT_EQ(std::memcmp(&row[i], &observed[i], sizeof(float)), 0)
              << name << " of agent " << agent << ": " << row[i] << ", " << observed[i];
        }
      }
    }
  }
}

// A choice among options is more than a command of the body.
TEST(PolicyRows, DoNotOfferOptions) {
  const auto codec = make_policy_rows();
  EXPECT_THAT(codec->action_sets(), testing::Not(testing::Contains("options/1")));
  EXPECT_THAT(codec->feature_sets(), testing::Not(testing::Contains("team/1")));
  const auto chosen = codec->choose({"ego/1", "options/1", 10, 11});
  EXPECT_EQ(chosen.error().message, "the action set 'options/1', which was not offered");
}

TEST(PolicyRows, WithFewerPlayersShowTheNearest) {
  Begun begun;
  play(begun.episode, *begun.setup, 40, kIntercept);
  const auto codec = make_policy_rows();
  ASSERT_TRUE(codec->choose({"ego/1", "low_discrete/1", 2, 1}));
  std::vector<float> few;
  std::vector<std::uint8_t> mask;
  codec->encode(*begun.episode.world_model(7), few, mask);
  EXPECT_EQ(mask.size(), 81U);
  ASSERT_TRUE(codec->choose({"ego/1", "low_discrete/1", 10, 11}));
  std::vector<float> all;
  codec->encode(*begun.episode.world_model(7), all, mask);

  // Column 3 of a player is the distance; the own columns come first.
  constexpr std::size_t kOwn = 31;
  constexpr std::size_t kWidth = 10;
  std::vector<float> distances;
  for (std::size_t i = 0; i < 10; ++i) {
    const std::size_t first = kOwn + i * kWidth;
    if (all[first] > 0.0F) distances.push_back(all[first + 3]);
  }
  std::ranges::sort(distances);

  ASSERT_GE(distances.size(), 2U);
  EXPECT_EQ(few[kOwn + 3], distances[0]);
  EXPECT_EQ(few[kOwn + kWidth + 3], distances[1]);
  EXPECT_TRUE(std::equal(few.begin(), few.begin() + kOwn, all.begin()));
}

TEST(PolicyRows, DecodeTheActionsOfTheSet) {
  Begun begun;
  const player::WorldModel& world = *begun.episode.world_model(5);
  const auto codec = make_policy_rows();
  ASSERT_TRUE(codec->choose({"ego/1", "low/1", 0, 0}));
  const std::array<float, 6> dash = {0.0F, 150.0F, 45.0F, 0.0F, 0.0F, 0.0F};
  const auto command = codec->decode(world, dash.data());
  ASSERT_TRUE(command);
  EXPECT_EQ(std::get<soccer::Dash>(*command).power, 100.0) << "clipped";
  EXPECT_EQ(std::get<soccer::Dash>(*command).direction, 45.0);

  using Limits = std::numeric_limits<float>;
  for (const auto& [column, value] :
       {std::pair{0, 3.0F}, std::pair{0, -1.0F}, std::pair{0, Limits::quiet_NaN()},
        std::pair{5, Limits::infinity()}}) {
    std::array<float, 6> bad = dash;
    bad.at(base::index(column)) = value;
    EXPECT_FALSE(codec->decode(world, bad.data())) << value;
  }

  // A kick without the ball acts as no action.
  const std::array<float, 6> kick = {2.0F, 0.0F, 0.0F, 0.0F, 100.0F, 0.0F};
  EXPECT_EQ(std::get<soccer::Turn>(*codec->decode(world, kick.data())).moment, 0.0);
}

TEST(PolicyRows, NameWhatDoesNotExist) {
  const auto codec = make_policy_rows();
  EXPECT_EQ(codec->choose({"ego/7", "low/1", 0, 0}).error().message,
            "the feature set 'ego/7', which was not offered");
  EXPECT_EQ(codec->choose({"ego/1", "low", 0, 0}).error().message,
            "the action set 'low', which was not offered");
  EXPECT_EQ(codec->choose({"ego/1", "low/1", 11, 0}).error().message,
            "11 teammates and 0 opponents; the limits are 10 and 11");
}

}  // namespace
}  // namespace cls::match
