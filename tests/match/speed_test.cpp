// Attribution of wall time to server, agents and Playmakers.
#include "match/result/speed.h"

#include <gtest/gtest.h>

#include <array>

namespace {

using cls::match::SpeedLimit;
using cls::match::SpeedMeter;
using cls::match::SpeedResult;
using cls::soccer::Side;
using std::chrono::milliseconds;

using Turns = std::array<SpeedMeter::SideTurn, 2>;

TEST(SpeedMeter, GivesWaitingTimeToThePlaymakerThatIsAwaited) {
  SpeedMeter meter;
  meter.add_server(milliseconds(10));
  Turns turns = {{{Side::kLeft, {milliseconds(10), milliseconds(0)}},
                  {Side::kRight, {milliseconds(90), milliseconds(90)}}}};
  meter.add_turns(milliseconds(90), turns);
  const SpeedResult speed = meter.result();
  EXPECT_EQ(name(speed.limited_by), "right playmaker");
  EXPECT_DOUBLE_EQ(speed.shares.server, 0.1);
  EXPECT_DOUBLE_EQ(speed.shares.right_playmaker, 0.85);  // 80 ms alone, half of 10 ms
  EXPECT_DOUBLE_EQ(speed.shares.agents, 0.05);
  EXPECT_DOUBLE_EQ(speed.shares.left_playmaker, 0.0);
}

TEST(SpeedMeter, NamesBothPlaymakersWhenTheyAreEquallySlow) {
  SpeedMeter meter;
  meter.add_server(milliseconds(40));
  Turns turns = {{{Side::kLeft, {milliseconds(60), milliseconds(60)}},
                  {Side::kRight, {milliseconds(60), milliseconds(60)}}}};
  meter.add_turns(milliseconds(60), turns);
  const SpeedResult speed = meter.result();
  EXPECT_EQ(name(speed.limited_by), "both playmakers");
  EXPECT_DOUBLE_EQ(speed.limiting_share(), 0.6);
}

TEST(SpeedMeter, NamesServerAndClock) {
  SpeedMeter meter;
  meter.add_server(milliseconds(30));
  meter.add_clock(milliseconds(20));
  EXPECT_EQ(name(meter.result().limited_by), "server");
  meter.add_clock(milliseconds(50));
  EXPECT_EQ(name(meter.result().limited_by), "clock");
}

TEST(SpeedMeter, HasNoVerdictWithoutTime) { EXPECT_EQ(name(SpeedMeter().result().limited_by), ""); }

TEST(SpeedMeter, DescribesTheVerdictInOneLine) {
  SpeedResult speed;
  speed.limited_by = SpeedLimit::kTrainerPlaymaker;
  speed.shares.trainer_playmaker = 1.0;
  speed.decision_ms.p99 = 12345.0;
  const std::string line = describe(speed);
  EXPECT_EQ(line, "limited by the trainer Playmaker (100 %), p99 12345 ms: too slow for real time");
  EXPECT_LE(line.size(), 78U);
}

}  // namespace
