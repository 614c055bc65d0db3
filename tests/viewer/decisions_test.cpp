// Recorded decisions written as chunks and read again, and what corrupt files become.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "base/index.h"
#include "tests/support/error_of.h"
#include "tests/support/files.h"
#include "viewer/decisions/decision_plan.h"
#include "viewer/decisions/decision_reader.h"
#include "viewer/decisions/decision_writer.h"

namespace cls::viewer {
namespace {

using soccer::Side;

// A decision with everything in it; numbers have the precision of the format.
DecisionSample sample_at(int cycle) {
  DecisionSample sample;
  sample.cycle = cycle;
  sample.stopped = cycle % 5;
  sample.self = {-10.0 + 0.25 * cycle, 3.5};
  sample.self_body = cycle % 2 == 0 ? 179.0 : -179.0;
  sample.self_neck = -30.0;
  sample.self_age = 0;

  sample.ball = {12.25, -33.75};
  sample.ball_velocity = {2.5, -0.75};
  sample.ball_age = cycle % 3;
  sample.ball_velocity_age = kUnknownAge;
  sample.players[13] = {cycle % 4, {20.5, -1.2}};
  sample.players[21] = {kUnknownAge, {}};
  sample.unnumbered.push_back({40 + cycle / 10, Side::kRight, {2, {1.5, 2.5}}});

  sample.own_reach = 12;
  sample.maker = DecisionMaker::kSureShot;
  sample.call = cycle % 7 == 0 ? 1 : 0;
  sample.reply = "e body_intercept_and_score save_recovery=true\n- neck_scan_field\n";
  sample.commands = "(dash 100)(turn_neck " + std::to_string(cycle) + ")";
  sample.plan = cycle == 3 ? "* pass 9 (12, -4) 45.2\n" : "";
  sample.drawings = cycle % 2 == 0 ? "1024 c -0.5 " + std::to_string(cycle) + ".25 3 red\n" : "";
  sample.latency_us = 1000 - cycle;
  return sample;
}

void expect_equal(const EstimatedPlayer& a, const EstimatedPlayer& b) {
  EXPECT_EQ(a.age, b.age);
  if (a.age == kUnknownAge) return;
  EXPECT_NEAR(a.position.x, b.position.x, 1e-9);
  EXPECT_NEAR(a.position.y, b.position.y, 1e-9);
}

// Everything that is no measure.
auto exact_values_of(const DecisionSample& s) {
  return std::tie(s.cycle, s.stopped, s.ball_age, s.ball_velocity_age, s.own_reach,
                  s.opponent_reach, s.maker, s.call, s.reply, s.commands, s.plan, s.drawings,
                  s.latency_us);
}

void expect_equal(const DecisionSample& a, const DecisionSample& b) {
  EXPECT_EQ(exact_values_of(a), exact_values_of(b));
  EXPECT_NEAR(a.self.x, b.self.x, 1e-9);
  EXPECT_NEAR(a.self_body, b.self_body, 1e-9);
  EXPECT_NEAR(a.self_neck, b.self_neck, 1e-9);
  EXPECT_NEAR(a.ball.y, b.ball.y, 1e-9);
  EXPECT_NEAR(a.ball_velocity.x, b.ball_velocity.x, 1e-9);

  for (std::size_t i = 0; i < a.players.size(); ++i) expect_equal(a.players[i], b.players[i]);
  ASSERT_EQ(a.unnumbered.size(), b.unnumbered.size());

  for (std::size_t i = 0; i < a.unnumbered.size(); ++i) {
    EXPECT_EQ(a.unnumbered[i].id, b.unnumbered[i].id);
    EXPECT_EQ(a.unnumbered[i].side, b.unnumbered[i].side);
    EXPECT_NEAR(a.unnumbered[i].estimate.position.x, b.unnumbered[i].estimate.position.x, 1e-9);
  }
}

// Player 7 decides in more cycles than a block has, player 11 in some.
std::string stream_of_two_players() {
  std::string stream;
  DecisionWriter writer;
  writer.append_header(Side::kRight, "Amber", stream);
  for (int cycle = 0; cycle < 700; ++cycle) {
    writer.append(7, sample_at(cycle), stream);
    if (cycle % 10 == 0) writer.append(11, sample_at(cycle), stream);
  }
  writer.append_end(stream);
  return stream;
}

// A stream of the left team with one player's decisions.
std::string stream_of(int unum, const std::vector<DecisionSample>& samples) {
  std::string stream;
  DecisionWriter writer;
  writer.append_header(Side::kLeft, "Azure", stream);
  for (const DecisionSample& sample : samples) writer.append(unum, sample, stream);
  writer.append_end(stream);
  return stream;
}

std::string error_of(std::string_view stream) { return tests::error_of(read_decisions(stream)); }

TEST(Decisions, AreReadAsTheyWereWritten) {
  const auto decisions = read_decisions(stream_of_two_players());
  ASSERT_TRUE(decisions) << decisions.error().message;
  EXPECT_EQ(decisions->side, Side::kRight);
  EXPECT_EQ(decisions->team, "Amber");
  ASSERT_EQ(decisions->players[6].size(), 700U);
  ASSERT_EQ(decisions->players[10].size(), 70U);
  EXPECT_TRUE(decisions->players[0].empty());
  for (const int cycle : {0, 1, 3, 511, 512, 699}) {
    SCOPED_TRACE(cycle);
    expect_equal(decisions->players[6][base::index(cycle)], sample_at(cycle));
  }
  expect_equal(decisions->players[10][69], sample_at(690));
}

TEST(Decisions, HoldASlotForEachTrackedPlayer) {
  DecisionSample crowded;
  for (int id = 1; id <= 30; ++id) crowded.unnumbered.push_back({id, Side::kLeft, {0, {}}});
  DecisionSample later;
  later.unnumbered.push_back({22, Side::kLeft, {1, {5, 5}}});
  later.unnumbered.push_back({31, Side::kRight, {0, {6, 6}}});
  const auto decisions = read_decisions(stream_of(1, {crowded, later}));
  ASSERT_TRUE(decisions) << decisions.error().message;
  EXPECT_EQ(decisions->players[0][0].unnumbered.size(), 22U);
  ASSERT_EQ(decisions->players[0][1].unnumbered.size(), 2U);
  // The new player has the first free slot, the other one its own.
  EXPECT_EQ(decisions->players[0][1].unnumbered[0].id, 31);
  EXPECT_EQ(decisions->players[0][1].unnumbered[1].id, 22);
}

TEST(Decisions, OfSomePlayersCanBeSelected) {
  const std::string stream = stream_of_two_players();
  const auto one = select_players(stream, {11});
  ASSERT_TRUE(one) << one.error().message;
  EXPECT_LT(one->size(), stream.size() / 5);
  const auto decisions = read_decisions(*one);
  ASSERT_TRUE(decisions) << decisions.error().message;
  EXPECT_TRUE(decisions->players[6].empty());
  EXPECT_EQ(decisions->players[10].size(), 70U);
  EXPECT_EQ(select_players(stream, {}).value(), stream);
}

std::string replies_of(const std::vector<std::string>& replies) {
  std::vector<DecisionSample> samples(replies.size());
  for (std::size_t i = 0; i < replies.size(); ++i) samples[i].reply = replies[i];
  return stream_of(3, samples);
}

// Texts differ in numbers of all kinds, and what only looks like one.
TEST(Decisions, KeepTextsAsTheyAre) {
  std::vector<std::string> texts = {"",    "a -",  "1",     "-1",
                                    "1-2", "1--2", "1.2.3", "\xFF 5 \xC3\xA4\n2\n"};
  for (const char* number :
       {"1",    "-1", "99999", "-99999.999",   "0",       "0.5",  "-0.001", "-0", "-0.00", "1.50",
        "1.",   ".5", "007",   "123456789012", "1.23456", "1e-5", "-",      "1",  "1.005", "1.0",
        "-1.5", "2"}) {
    texts.push_back(fmt::format("a {} b", number));
  }

  const auto decisions = read_decisions(replies_of(texts));
  ASSERT_TRUE(decisions) << decisions.error().message;
  ASSERT_EQ(decisions->players[2].size(), texts.size());

  for (std::size_t i = 0; i < texts.size(); ++i) {
    EXPECT_EQ(decisions->players[2][i].reply, texts[i]) << i;
  }
}

TEST(Decisions, CutTextsThatAreTooLong) {
  const auto decisions =
      read_decisions(replies_of({std::string(2 * kMaxDecisionText, 'x'), std::string("a\x01z")}));
  ASSERT_TRUE(decisions) << decisions.error().message;
  EXPECT_EQ(decisions->players[2][0].reply.size(), kMaxDecisionText);
  EXPECT_EQ(decisions->players[2][1].reply, "a z");
}

TEST(Decisions, OfSomeCyclesCanBeSelected) {
  const std::string stream = stream_of_two_players();
  const auto some = select_cycles(stream, {{100, 119}, {600, 600}});
  ASSERT_TRUE(some) << some.error().message;
  const auto decisions = read_decisions(*some);
  ASSERT_TRUE(decisions) << decisions.error().message;
  ASSERT_EQ(decisions->players[6].size(), 21U);
  EXPECT_EQ(decisions->players[10].size(), 3U);
  expect_equal(decisions->players[6][5], sample_at(105));
  expect_equal(decisions->players[6][20], sample_at(600));
  EXPECT_EQ(select_cycles(stream, {}).value(), stream);
  EXPECT_FALSE(select_cycles(stream.substr(0, 1000), {{1, 2}}));
}

// Decisions that an earlier version recorded can be watched.
TEST(Decisions, OfTheFirstVersionAreRead) {
  const auto decisions =
      read_decisions(tests::read_file(tests::fixture("formats/right.world-models")));
  ASSERT_TRUE(decisions) << decisions.error().message;
  EXPECT_EQ(decisions->side, Side::kRight);
  EXPECT_EQ(decisions->team, "hold");

  for (const auto& samples : decisions->players) ASSERT_EQ(samples.size(), 104U);
  const DecisionSample& last = decisions->players[6].back();
  EXPECT_EQ(last.cycle, 4);
  EXPECT_EQ(last.reply, "f body_turn_to_ball cycle=1\ne neck_turn_to_ball\n");
  EXPECT_EQ(last.commands, "(turn 0)(turn_neck 0)(say)");
  EXPECT_NEAR(last.self.y, 11.0, 1e-9);
  EXPECT_NEAR(last.ball.x, 0.03, 1e-9);
  EXPECT_EQ(last.ball_age, 0);
}

TEST(Decisions, SayWhyTheyCannotBeRead) {
  const std::string stream = stream_of_two_players();
  EXPECT_EQ(error_of(""), "incomplete decisions: the match did not end");
  EXPECT_EQ(error_of(stream.substr(0, stream.size() / 2)),
            "incomplete decisions: the match did not end");

  ByteReader header(stream);
  header.byte();
  header.string();

  EXPECT_EQ(error_of(stream.substr(stream.size() - header.left())), "corrupt decisions: no header");

  std::string other = stream;
  other.replace(other.find("cls.decisions/1"), 15, "cls.decisions/9");
  EXPECT_EQ(error_of(other),
            "schema cls.decisions/9 is newer than this cls reads (cls.decisions/1); update cls");
  EXPECT_EQ(tests::error_of(select_players(other, {})), error_of(other));

  other.replace(other.find("cls.decisions/9"), 15, "cls.excisions/1");
  EXPECT_EQ(error_of(other), "schema 'cls.excisions/1' is not cls.decisions/1");
}

// Whatever a file contains, reading it ends with an error or with decisions.
TEST(Decisions, SurviveAnyChangeOfAByte) {
  const std::string stream = stream_of(2, {sample_at(0), sample_at(1), sample_at(2), sample_at(3)});
  int unchanged = 0;
  for (std::size_t at = 0; at < stream.size(); ++at) {
    for (const int flip : {1, 0x80, 0xFF}) {
      std::string changed = stream;
      changed[at] = static_cast<char>(changed[at] ^ flip);
      if (read_decisions(changed)) ++unchanged;
      std::ignore = select_players(changed, {2});
    }
  }
  // Latencies, and the end's count, are not part of the checksum.
  EXPECT_LT(unchanged, 100);
}

TEST(DecisionPlan, HasTheOptionsOfAPolicyMostLikelyFirst) {
  const auto actions = considered_actions(
      "- shoot (52.5, -1.5) 8.1%\n- hold 20%\n- dribble -157.5 deg (-1.5, 2) 20% room 0.5\n"
      "* through pass 9 (12.3, -4) 51.9% room 3.1\n");
  ASSERT_EQ(actions.size(), 4U);
  EXPECT_EQ(actions[0].name, "through pass");
  EXPECT_EQ(actions[0].unum, 9);
  EXPECT_TRUE(actions[0].chosen && actions[0].is_share && !actions[1].chosen);
  EXPECT_EQ(actions[0].value, 51.9);
  EXPECT_EQ(actions[0].target, (soccer::Vec2{12.3, -4.0}));
  EXPECT_EQ(actions[0].room, 3.1);
  EXPECT_EQ(actions[1].name, "hold");
  EXPECT_FALSE(actions[1].target || actions[1].room || actions[1].unum != 0);
  EXPECT_EQ(actions[2].name, "dribble -157.5 deg");
  EXPECT_EQ(actions[2].unum, 0);
  EXPECT_EQ(actions[3].value, 8.1);
}

TEST(DecisionPlan, HasWhatThePlannerConsidered) {
  const auto actions = considered_actions("- pass 9 (12.3, -4) 45.2\n* hold 7 (1, 0) -30\n");
  ASSERT_EQ(actions.size(), 2U);
  EXPECT_EQ(actions[1].name, "hold");
  EXPECT_EQ(actions[1].unum, 7);
  EXPECT_EQ(actions[1].value, -30.0);
  EXPECT_TRUE(actions[1].chosen);
  EXPECT_FALSE(actions[0].is_share);
}

TEST(DecisionPlan, LeavesOutWhatIsNoLineOfIt) {
  for (const char* text : {"", "\n", "*", "* ", "* hold", "hold 20%", "- hold twenty%", "- 20%",
                           "* pass 9 (12.3) x"}) {
    EXPECT_TRUE(considered_actions(text).empty()) << text;
  }
  const auto odd = considered_actions("* pass (1, 2, 3) 4%\n");
  ASSERT_EQ(odd.size(), 1U);
  EXPECT_FALSE(odd[0].target);
}

}  // namespace
}  // namespace cls::viewer
