// Say messages: recorded ones against the ground truth of their match, and round trips of all
// kinds.
#include "player/perception/say_message.h"

#include <gtest/gtest.h>

#include <string>

namespace cls::player {
namespace {

const soccer::ServerParams kServer;

template <typename Message>
Message read(std::string_view text) {
  const std::optional<SayMessage> message = parse_say_message(text, kServer);
  EXPECT_TRUE(message.has_value());
  EXPECT_TRUE(text.empty());
  return std::get<Message>(*message);
}

std::string written(const SayMessage& message) {
  std::string out;
  EXPECT_TRUE(append_say_message(message, kServer, out));
  return out;
}

void expect_near(Vec2 a, Vec2 b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

// Said by the left team in a recorded match; expected values from its game log in the cycle of
// hearing. Speakers report rounded estimates.
TEST(SayMessage, RecordedMessagesMatchGameLog) {
  // Cycle 18.
  const auto three = read<SayPlayers>("RFwbdgqTAB");
  ASSERT_EQ(three.players.size(), 3U);
  EXPECT_EQ(three.players[0].number, 10);
  expect_near(three.players[0].position, {-2.63, 21.03}, 0.8);
  EXPECT_EQ(three.players[1].number, 20);  // opponent 9
  expect_near(three.players[1].position, {6.36, 10.93}, 1.1);
  EXPECT_EQ(three.players[2].number, 9);
  expect_near(three.players[2].position, {-3.74, -18.00}, 0.5);

  // Cycle 26: the kick-off pass to the center forward.
  const auto pass = read<SayPass>("pk4PrIBSnx");
  EXPECT_EQ(pass.receiver, 11);
  expect_near(pass.ball.position, {-2.126, -0.732}, 0.06);
  expect_near(pass.ball.velocity, {1.359, -0.028}, 0.08);

  // Cycle 41.
  const auto both = read<SayBallPlayer>("BPapzn(<-F");
  expect_near(both.ball.position, {7.871, -14.665}, 0.3);
  expect_near(both.ball.velocity, {0.550, -1.872}, 0.06);
  EXPECT_EQ(both.player.number, 17);  // opponent 6
  expect_near(both.player.position, {8.82, -2.56}, 1.4);
  EXPECT_NEAR(both.body, -66.2, 1.0);
}

TEST(SayMessage, ParsesSeveralMessagesInOneSay) {
  std::string_view text = "Pajqs9";
  const auto first = parse_say_message(text, kServer);
  ASSERT_TRUE(first && std::holds_alternative<SayPlayers>(*first));
  const auto second = parse_say_message(text, kServer);
  ASSERT_TRUE(second);
  EXPECT_DOUBLE_EQ(std::get<SayStamina>(*second).fraction, 1.0);
  EXPECT_TRUE(text.empty());
}

TEST(SayMessage, RoundTripsEveryKind) {
  SayPlayers three;
  three.players.push_back({4, {-20.37, 12.2}});
  three.players.push_back({22, {30.66, -33.37}});
  three.players.push_back({1, {-52.5, 0.02}});
  const SayBall ball{{10.0, -20.0}, {1.2, -0.7}};
  const SayGoalie goalie{{48.2, -3.1}, -120.0};

  const std::pair<SayMessage, std::size_t> all[] = {
      {ball, 6},
      {SayPass{7, {3.0, 4.0}, ball}, 10},
      {SayIntercept{13, 5}, 3},
      {goalie, 5},
      {SayGoalieAndPlayer{goalie, {3, {1.0, 2.0}}}, 8},
      {SayOffsideLine{33.3}, 2},
      {SayDefenseLine{-28.0}, 2},
      {SayWaitRequest{}, 1},
      {SaySetplay{12}, 2},
      {SayPassRequest{{20.0, 5.0}}, 4},
      {SayStamina{0.4}, 2},
      {SayRecovery{0.9}, 2},
      {SayCapacity{0.1}, 2},
      {SayDribble{{-4.5, 11.0}, 6}, 4},
      {SayBallGoalie{ball, goalie}, 10},
      {three, 10},
      {SaySelf{{10.0, -10.0}, 90.0, 0.7}, 5},
      {SayTeammate{11, {-7.0, 3.0}, 44.0}, 5},
      {SayOpponent{2, {7.0, -3.0}, -44.0}, 5},
      {SayBallPlayer{ball, {14, {22.0, 30.0}}, 178.0}, 10},
  };
  for (const auto& [message, length] : all) {
    const std::string text = written(message);
    EXPECT_EQ(text.size(), length) << text;

    std::string_view rest = text;
    const auto again = parse_say_message(rest, kServer);
    ASSERT_TRUE(again) << text;
    EXPECT_TRUE(rest.empty());
    EXPECT_EQ(again->index(), message.index());
    EXPECT_EQ(written(*again), text);
  }

  const auto players = read<SayPlayers>(written(three));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(players.players[i].number, three.players[i].number);
    expect_near(players.players[i].position, three.players[i].position, 0.32);
  }

  const auto both = read<SayBallGoalie>(written(SayBallGoalie{ball, goalie}));
  expect_near(both.ball.position, ball.position, 0.051);
  expect_near(both.ball.velocity, ball.velocity, 0.05);
  expect_near(both.goalie.position, goalie.position, 0.051);
  EXPECT_NEAR(both.goalie.body, -120.0, 0.5);

  const auto pass = read<SayPass>(written(SayPass{7, {3.0, 4.0}, ball}));
  EXPECT_EQ(pass.receiver, 7);
  expect_near(pass.point, {3.0, 4.0}, 0.07);
  EXPECT_NEAR(read<SayDefenseLine>(written(SayDefenseLine{-28.0})).x, -28.0, 0.3);
}

TEST(SayMessage, RejectsUnsupportedValues) {
  std::string out = "x";
  for (const SayMessage& message : std::initializer_list<SayMessage>{
           SayPass{12, {}, {}}, SayIntercept{23, 1}, SayIntercept{1, 74},
           SayGoalie{{30.0, 0.0}, 0.0}, SayGoalie{{50.0, 25.0}, 0.0}, SayOffsideLine{9.0},
           SayDefenseLine{-9.0}, SayPlayers{}, SayTeammate{0, {}, 0.0}}) {
    EXPECT_FALSE(append_say_message(message, kServer, out)) << message.index();
  }
  EXPECT_EQ(out, "x");

  // Positions outside the pitch are clamped to its border.
  expect_near(read<SayBall>(written(SayBall{{60.0, -40.0}, {9.0, -9.0}})).position, {52.5, -34.0},
              1e-9);
}

TEST(SayMessage, WritesNumbersThatAreNotFiniteAsLimitsOrZero) {
  const double nan = std::nan("");
  const auto ball = read<SayBall>(written(SayBall{{nan, 0.0}, {nan, -HUGE_VAL}}));
  EXPECT_EQ(ball.velocity, (Vec2{0.0, -kServer.ball_speed_max}));
  EXPECT_EQ(ball.position.x, -52.5);
}

TEST(SayMessage, RejectsInvalidTextWithoutConsumingIt) {
  for (const char* text : {"", "Z123", "b1234", "Rabcdefgh", "p&&&&&&&&&", "iz9", "Pab"}) {
    std::string_view rest = text;
    EXPECT_FALSE(parse_say_message(rest, kServer)) << text;
    EXPECT_EQ(rest, text);
  }
}

}  // namespace
}  // namespace cls::player
