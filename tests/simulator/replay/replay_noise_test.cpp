// Outcomes that noise decides and a record reveals, in excerpts of a few cycles of recorded
// matches.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/motion/motion.h"
#include "simulator/replay/post_bounce.h"
#include "simulator/replay/stronger_push.h"
#include "tests/simulator/replay/replayed_logs.h"
#include "tests/simulator/stage.h"
#include "tests/support/files.h"

namespace cls::simulator {
namespace {

using gamelog::MatchRecord;

Logs read_excerpt(const std::string& name) {
  return read_logs(tests::fixture("simulator/excerpts/" + name));
}

int excused(const LogAgreement& agreement, Excuse why) {
  return agreement.by_cause[static_cast<std::size_t>(why)];
}

const ClassTally& of_class(const LogAgreement& agreement, StepClass kind) {
  return agreement.by_class[static_cast<std::size_t>(kind)];
}

std::size_t frame_at(const MatchRecord& game, int time) {
  const auto found = std::find(game.time.begin(), game.time.end(), time);
  return static_cast<std::size_t>(found - game.time.begin());
}

class ReplayExcerpt : public ::testing::TestWithParam<const char*> {};

TEST_P(ReplayExcerpt, IsFullyExplained) {
  const LogAgreement agreement = replay(read_excerpt(GetParam()));
  EXPECT_TRUE(agreement.has_noise);
  EXPECT_GE(agreement.ball.steps, 3);
  EXPECT_EQ(all_misses(agreement), "");
  EXPECT_EQ(agreement.agreed(), agreement.steps());
}

INSTANTIATE_TEST_SUITE_P(OfRealMatches, ReplayExcerpt,
                         ::testing::Values("post", "stronger-touch", "open-touch", "foul-caller",
                                           "kick-noise", "back-tackle", "pushed-goalie"));

TEST(ReplayNoise, TakesOverlapOfCatcherAndBallFromRecord) {
  const LogAgreement agreement = replay(read_excerpt("pushed-goalie"));
  EXPECT_EQ(of_class(agreement, StepClass::kBallCollision).steps, 1);
  EXPECT_EQ(excused(agreement, Excuse::kNoise), 0);
}

TEST(ReplayNoise, CountsPostBounce) {
  const LogAgreement agreement = replay(read_excerpt("post"));
  EXPECT_EQ(of_class(agreement, StepClass::kBallPost).steps, 1);
  EXPECT_EQ(of_class(agreement, StepClass::kBallPost).agreed, 1);
  EXPECT_LT(of_class(agreement, StepClass::kBallPost).worst, 5e-3);
  EXPECT_EQ(agreement.ball.steps, 4);  // none skipped
}

TEST(ReplayNoise, ReportsBounceThatNoiseCannotExplain) {
  Logs logs = read_excerpt("post");
  const std::size_t frame = frame_at(logs.game, 135);
  gamelog::Point& velocity = logs.game.ball_velocity[frame];
  const Vec2 turned = soccer::rotated_degrees({velocity.x, velocity.y}, 2.0);
  velocity = {static_cast<float>(turned.x), static_cast<float>(turned.y)};
  const LogAgreement agreement = replay(logs);
  const bool reported = std::any_of(
      agreement.misses.begin(), agreement.misses.end(),
      [](const Miss& miss) { return miss.clock.time == 135 && miss.slot == kNoPlayer; });
  EXPECT_TRUE(reported) << all_misses(agreement);
}

TEST(ReplayNoise, ExcusesLastTouchOnlyWhenNoiseDecides) {
  EXPECT_EQ(excused(replay(read_excerpt("open-touch")), Excuse::kToucher), 1);
  // Here the displacement of the ball shows that the push of the attacker was stronger.
  Logs logs = read_excerpt("stronger-touch");
  EXPECT_EQ(excused(replay(logs), Excuse::kToucher), 0);

  for (std::size_t i = frame_at(logs.game, 1670); i < logs.game.frames(); ++i) {
    logs.game.mode[i] = PlayMode::kCornerKickLeft;
  }
  const std::string_view call = "corner_kick_l";
  for (gamelog::RclLine& line : logs.text.lines) {
    if (line.source != gamelog::RclSource::kReferee) continue;
    line.offset = static_cast<std::uint32_t>(logs.text.text.size());
    line.length = static_cast<std::uint32_t>(call.size());
    logs.text.text += call;
  }
  const LogAgreement agreement = replay(logs);

  EXPECT_GT(agreement.mode.misses(), 0);
  EXPECT_EQ(excused(agreement, Excuse::kToucher), 0);
}

PostBounce bounce_with_noise(Vec2 noise) {
  PostBounce bounce;
  bounce.from = {50.2, 6.1};
  bounce.expected = bounce.from + Vec2{2.3, 0.9};
  bounce.reach = 0.05 * Vec2{2.3, 0.9}.length();
  bounce.radius = 0.085;
  bounce.decay = 0.94;
  bounce.goal_width = 14.02;
  Vec2 position = bounce.from;
  Vec2 velocity = Vec2{2.3, 0.9} + noise;
  soccer::RandomStream stream(1, "test");
  EXPECT_TRUE(advance_past_posts(position, velocity, bounce.radius, bounce.goal_width, stream));

  const auto rounded = [](Vec2 v) {
    return Vec2{std::rint(v.x * 1e4) / 1e4, std::rint(v.y * 1e4) / 1e4};
  };

  bounce.to = rounded(position);
  bounce.velocity = rounded(velocity * bounce.decay);
  return bounce;
}

TEST(PostBounce, FindsNoiseBeforeBounce) {
  for (const Vec2 noise : {Vec2{0.0, 0.0}, Vec2{0.05, 0.05}, Vec2{-0.08, 0.03}}) {
    const PostBounce bounce = bounce_with_noise(noise);
    const auto arrival = arrival_without_post(bounce);
    ASSERT_TRUE(arrival);
    EXPECT_NEAR(arrival->x, bounce.expected.x + noise.x, 5e-4);
    EXPECT_NEAR(arrival->y, bounce.expected.y + noise.y, 5e-4);
  }
}

TEST(PostBounce, FindsNothingWhenNoiseCannotReachPost) {
  PostBounce bounce = bounce_with_noise({});
  bounce.expected = bounce.from + Vec2{-2.3, 0.9};
  EXPECT_FALSE(arrival_without_post(bounce));
  bounce = bounce_with_noise({});
  bounce.velocity = bounce.velocity * 1.2;  // faster than possible with noise
  EXPECT_FALSE(arrival_without_post(bounce));
  bounce = bounce_with_noise({});
  bounce.velocity = {};
  EXPECT_FALSE(arrival_without_post(bounce));
}

/// Two pushes of a resting ball, (1, 0) and (0, 1).
struct TwoPushes {
  tests::Stage stage;
  std::vector<BallPush> pushes = {{0, {1.0, 0.0}, 0.2}, {11, {0.0, 1.0}, 0.2}};

  std::vector<Slot> strongest(std::optional<Vec2> way) {
    return strongest_pushers(stage.world, pushes, way);
  }
};

TEST(StrongerPush, IsUndecidedWithoutDisplacement) {
  TwoPushes two;
  EXPECT_EQ(two.strongest(std::nullopt), (std::vector<Slot>{0, 11}));
  EXPECT_EQ(two.strongest(Vec2{1.0, 1.0}), (std::vector<Slot>{0, 11}));
  two.pushes[0].noise_max = two.pushes[1].noise_max = 0.05;
  two.pushes[0].acceleration = {1.2, 0.0};
  EXPECT_EQ(two.strongest(std::nullopt), std::vector<Slot>{0});
  two.pushes.clear();
  EXPECT_TRUE(two.strongest(std::nullopt).empty());
}

TEST(StrongerPush, FollowsFromDisplacement) {
  TwoPushes two;
  EXPECT_EQ(two.strongest(Vec2{1.25, 0.75}), std::vector<Slot>{0});
  EXPECT_EQ(two.strongest(Vec2{0.75, 1.25}), std::vector<Slot>{11});
}

}  // namespace
}  // namespace cls::simulator
