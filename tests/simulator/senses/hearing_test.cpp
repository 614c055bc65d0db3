// Audio model: distance, capacity, attention and order of hear messages.
#include "simulator/senses/hearing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/simulator/senses/scene.h"

namespace cls::simulator {
namespace {

using testing::HasSubstr;

class HearingTest : public testing::Test {
 protected:
  HearingTest() {
    for (Player& player : world_.players) player.ears.teammate_capacity = 1;
    for (Player& player : world_.players) player.ears.opponent_capacity = 1;
  }

  void say(const Player& speaker, const std::string& text) {
    queue_say(world_, {speaker.slot(), speaker.position, text}, me().slot(), hearing_);
  }

  /// The delivered messages, each after a line feed.
  std::string delivered(std::uint64_t seed = 1) {
    RandomStream choice(seed, "test");
    std::vector<soccer::Hear> heard;
    hear(world_, me().slot(), hearing_, choice, heard);
    std::string text;
    for (const soccer::Hear& message : heard) {
      text += '\n';
      soccer::format(message, soccer::Recipient::kPlayer, text);
    }
    return text;
  }

  Player& me() { return world_.player(Side::kLeft, 2); }
  Player& mate() { return world_.player(Side::kLeft, 3); }
  Player& foe() { return world_.player(Side::kRight, 4); }

  World world_ = [] {
    World world = empty_pitch();
    place(world, Side::kLeft, 2, {0, 0}, 90);
    place(world, Side::kLeft, 3, {10, 0});
    place(world, Side::kRight, 4, {-10, 0.1});
    return world;
  }();
  PendingMessages hearing_;
};

TEST_F(HearingTest, DeliversAllOwnMessages) {
  say(me(), "x1");
  say(me(), "x11");
  EXPECT_EQ(delivered(), "\n(hear 0 self \"x1\")\n(hear 0 self \"x11\")");
  EXPECT_EQ(delivered(), "");
}

TEST_F(HearingTest, TruncatesDirectionsRelativeToBody) {
  me().neck = 1.0;
  say(mate(), "one");
  EXPECT_EQ(delivered(), "\n(hear 0 -90 our 3 \"one\")");
  say(foe(), "one");
  EXPECT_EQ(delivered(), "\n(hear 0 89 opp \"one\")");
}

TEST_F(HearingTest, DeliversOwnMessagesFirst) {
  say(foe(), "o1");
  say(me(), "x2");
  EXPECT_EQ(delivered(), "\n(hear 0 self \"x2\")\n(hear 0 89 opp \"o1\")");
}

TEST_F(HearingTest, DeliversOneCompleteMessagePerSideAndCycle) {
  say(mate(), "a");
  say(mate(), "b");
  say(foe(), "c");
  say(foe(), "d");
  const std::string text = delivered();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  EXPECT_THAT(text, HasSubstr("our 3"));
  EXPECT_THAT(text, HasSubstr("opp"));
  EXPECT_EQ(me().ears.teammate_capacity, 0);
  EXPECT_EQ(me().ears.opponent_capacity, 0);
}

TEST_F(HearingTest, DeliversFurtherMessagesPartiallyInPartialMode) {
  me().ears.partial = {true, true};
  say(mate(), "p1");
  say(mate(), "p2");
  const std::string text = delivered();
  EXPECT_TRUE(text == "\n(hear 0 -90 our 3 \"p1\")\n(hear 0 our 3)" ||
              text == "\n(hear 0 -90 our 3 \"p2\")\n(hear 0 our 3)")
      << text;
  me().ears.opponent_capacity = 0;
  say(foe(), "x");
  EXPECT_EQ(delivered(), "\n(hear 0 opp)");
}

TEST_F(HearingTest, IgnoresMessagesWithEarOff) {
  me().ears.complete[1] = false;
  say(foe(), "x");
  EXPECT_EQ(delivered(), "");
  me().ears.partial[1] = true;
  say(foe(), "x");
  EXPECT_EQ(delivered(), "");
  EXPECT_EQ(me().ears.opponent_capacity, 1);
}

TEST_F(HearingTest, LimitsDistanceAtTimeOfSay) {
  mate().position = {50, 0};
  say(mate(), "far");
  EXPECT_EQ(delivered(), "\n(hear 0 -90 our 3 \"far\")");
  me().ears.teammate_capacity = 1;
  mate().position = {50.01, 0};
  say(mate(), "far");
  EXPECT_EQ(delivered(), "");
}

TEST_F(HearingTest, DeliversAttendedPlayerFirst) {
  Player& other = place(world_, Side::kLeft, 5, {0, 10});
  me().attention = mate().slot();
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    me().ears.teammate_capacity = 1;
    say(other, "no");
    say(mate(), "yes");
    say(other, "no");
    EXPECT_EQ(delivered(seed), "\n(hear 0 -90 our 3 \"yes\")");
  }
}

TEST_F(HearingTest, ChoosesUniformlyWithoutAttention) {
  Player& other = place(world_, Side::kLeft, 5, {0, 10});
  std::map<std::string, int> heard;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    me().ears.teammate_capacity = 1;
    say(mate(), "a");
    say(other, "b");
    say(other, "c");
    ++heard[delivered(seed)];
  }
  ASSERT_EQ(heard.size(), 3u);
  for (const auto& [text, count] : heard)
    EXPECT_NEAR(count, 1000, 104) << text;  // 4 standard deviations
}

}  // namespace
}  // namespace cls::simulator
