// Checks evaluated on a handmade record: each holds exactly where it should.
#include "scenario/check.h"

#include <gtest/gtest.h>

#include "base/text/json.h"
#include "scenario/check_file.h"

namespace cls::scenario {
namespace {

using base::Json;
using base::JsonDocument;
using base::JsonValue;
using soccer::PlayMode;
using soccer::Side;

constexpr int kSteps = 10;

// The ball rolls from x = 0 to 10 and left 9 follows 2 m behind; a goal falls at step 8.
RunRecord record() {
  RunRecord record;
  for (int step = 0; step <= kSteps; ++step) {
    StepFrame frame;
    frame.step = step;
    frame.cycle = 100 + step;
    frame.mode = step >= 8 ? PlayMode::kGoalLeft : PlayMode::kPlayOn;
    frame.score = {step >= 8 ? 1 : 0, 0};
    frame.ball.position = {static_cast<double>(step), 3.0};
    frame.ball.velocity = {1.0, 0.0};
    ObjectFrame& nine = frame.players[8];
    nine.position = {step - 2.0, 3.0};
    nine.stamina = 8000.0 - step;
    nine.on_pitch = true;
    nine.body = -90.0;
    record.frames.push_back(frame);
  }

  record.touches = {{2, 8}, {5, 12}, {7, 8}};  // left 9, right 2, left 9
  record.referee_messages = {{1, "play_on"}, {8, "goal_l_1"}};
  ReceivedReply reply{3, 9, {}};
  reply.actions.add_actions()->mutable_dash()->set_power(100.0F);
  reply.actions.add_actions()->mutable_neck_turn_to_ball();
  record.replies[0] = {reply};
  record.result.left.players.resize(1);
  record.result.left.players[0].unum = 9;
  record.result.left.players[0].missed = 2;
  record.result.left.players[0].commands = {{"dash", 7}};
  record.result.left.players[0].rpc_us = {500.0, 900.0, 2000.0, 3000.0};
  record.result.end_reason = match::EndReason::kFinished;
  record.game_log = "log";

  return record;
}

std::string ask(const std::string& text, const Json& golden = Json()) {
  const JsonDocument json = *JsonDocument::parse("s.json", text);
  const auto check = parse_check(JsonValue(json), kSteps, golden);
  EXPECT_TRUE(check) << check.error().message;
  return check ? failure(*check, record()) : "bad check";
}

#define EXPECT_HOLDS(text) EXPECT_EQ(ask(text), "")
#define EXPECT_FAILS(text, why) EXPECT_EQ(ask(text), why)

TEST(Check, ComparesPositionsAtStepsAndOverTime) {
  EXPECT_HOLDS(R"({"ball": {"x": 10, "y": 3, "speed": 1}})");
  EXPECT_FAILS(R"({"ball": {"x": 9}})",
               "at the end, step 10 (cycle 110): the ball is at (10.00, 3.00), not x == 9");
  EXPECT_HOLDS(R"({"ball": {"x": 4}, "at": 4})");
  EXPECT_FAILS(R"({"ball": {"x": 4}, "at": 5})",
               "at step 5 (cycle 105): the ball is at (5.00, 3.00), not x == 4");
  EXPECT_HOLDS(R"({"ball": {"x": {"<": 6}}, "always": [0, 5]})");
  EXPECT_FAILS(R"({"ball": {"x": {"<": 6}}, "always": [0, 6]})",
               "at step 6 (cycle 106): the ball is at (6.00, 3.00), not x < 6");
  EXPECT_HOLDS(R"({"ball": {"x": 6}, "sometime": [5, 7]})");
  EXPECT_FAILS(R"({"ball": {"x": 9}, "sometime": [5, 7]})",
               "never x == 9; at step 7 (cycle 107): the ball is at (7.00, 3.00)");
  EXPECT_HOLDS(R"({"ball": {"x": 9}, "never": [0, 8]})");
  EXPECT_FAILS(R"({"ball": {"x": 9}, "never": true})",
               "at step 9 (cycle 109): the ball is at (9.00, 3.00)");
}

TEST(Check, ComparesAreasAndDistances) {
  EXPECT_HOLDS(R"({"ball": {"in": "right_half"}})");
  EXPECT_HOLDS(R"({"ball": {"in": ["left_goal", "pitch"]}})");
  EXPECT_FAILS(R"({"ball": {"in": "right_penalty_area"}})",
               "at the end, step 10 (cycle 110): the ball is at (10.00, 3.00), not in "
               "right_penalty_area");
  EXPECT_HOLDS(R"({"player": "left 9", "is": {"near": "ball", "within": 2}, "always": true})");
  EXPECT_FAILS(R"({"player": "left 9", "is": {"near": "ball", "within": 1.9}})",
               "at the end, step 10 (cycle 110): left 9 is at (8.00, 3.00), 2.00 m from the ball, "
               "not within 1.9 m of the ball");
  EXPECT_HOLDS(R"({"player": "left 9", "is": {"near": [8, 3], "within": 0.1}})");
}

TEST(Check, ComparesPlayerState) {
  EXPECT_HOLDS(R"({"player": "left 9", "is": {"stamina": {"<": 7991}, "on_pitch": true}})");
  EXPECT_HOLDS(R"({"player": "left 9", "is": {"body": -90, "cards": 0}})");
  EXPECT_FAILS(R"({"player": "right 9", "is": {"on_pitch": true}})",
               "at the end, step 10 (cycle 110): right 9 is at (0.00, 0.00), on_pitch false, not "
               "on_pitch == true");
}

TEST(Check, ComparesPlayModesScoresAndRefereeMessages) {
  EXPECT_HOLDS(R"({"mode": "goal_l"})");
  EXPECT_HOLDS(R"({"mode": ["goal_r", "goal_l"], "at": "end"})");
  EXPECT_FAILS(R"({"mode": "goal_r"})", "never goal_r; at step 10 (cycle 110): the mode is goal_l");
  EXPECT_HOLDS(R"({"score": [1, 0]})");
  EXPECT_HOLDS(R"({"score": {"left": {">": 0}}})");
  EXPECT_FAILS(R"({"score": [1, 1]})", "the score is 1 : 0, not == 1 for the right");
  EXPECT_HOLDS(R"({"referee": "goal_l_1", "count": 1})");
  EXPECT_FAILS(R"({"referee": "offside_l"})",
               "referee message offside_l: 0 times, not >= 1 (messages: 1 play_on, 8 goal_l_1)");
}

TEST(Check, CountsTouches) {
  EXPECT_HOLDS(R"({"first_touch": "left 9"})");
  EXPECT_HOLDS(R"({"last_touch": "left"})");
  EXPECT_HOLDS(R"({"touches": "right 2", "count": 1})");
  EXPECT_HOLDS(R"({"touches": "left", "count": 2})");
  EXPECT_FAILS(R"({"first_touch": "right"})",
               "the first touch was by left 9 at step 2, not by right");
  EXPECT_FAILS(R"({"touches": "left 8"})", "left 8 touched the ball 0 times, not >= 1");
}

TEST(Check, CountsActionsAndCommands) {
  EXPECT_HOLDS(R"({"actions": "dash", "side": "left", "unum": 9, "count": 1})");
  EXPECT_HOLDS(R"({"actions": "*", "side": "left", "count": 2})");
  EXPECT_HOLDS(R"({"actions": "dash", "side": "left", "where": {"dash.power": {">": 99}}})");
  EXPECT_HOLDS(R"({"actions": "neck_turn_to_ball", "side": "left", "position": "first",
                   "count": 0})");
  EXPECT_HOLDS(R"({"actions": "dash", "side": "left", "steps": [4, 10], "count": 0})");
  EXPECT_FAILS(R"({"actions": "dash", "side": "right"})",
               "0 actions dash of the right Playmaker, not >= 1");
  EXPECT_HOLDS(R"({"commands": "dash", "side": "left", "unum": 9, "count": 7})");
  EXPECT_FAILS(R"({"commands": "kick", "side": "left"})",
               "0 commands kick of the left side, not >= 1");
}

TEST(Check, ComparesRepliesAndEndReason) {
  EXPECT_HOLDS(R"({"missed": 2, "side": "left"})");
  EXPECT_FAILS(R"({"missed": 0, "side": "left"})", "2 missed decisions of the left side, not == 0");
  EXPECT_HOLDS(R"({"latency_ms": {"p50": {"<": 1}, "max": 3}, "side": "left"})");
  EXPECT_FAILS(R"({"latency_ms": {"p99": {"<": 1}}, "side": "left"})",
               "the p99 latency of the slowest left player is 2.00 ms, not < 1");
  EXPECT_HOLDS(R"({"end": "finished"})");
  EXPECT_FAILS(R"({"end": "crashed"})", "the run ended as finished, not crashed");
}

TEST(Check, MissedDecisionsIncludeFirstError) {
  RunRecord run = record();
  run.result.left.errors.count = 2;
  run.result.left.errors.first = {"GetPlayerActions", "UNKNOWN", "no ball", 104, 9, ""};
  const JsonDocument json = *JsonDocument::parse("s.json", R"({"missed": 0, "side": "left"})");
  EXPECT_EQ(failure(*parse_check(JsonValue(json), kSteps, Json()), run),
            "2 missed decisions of the left side, not == 0; first error: GetPlayerActions of "
            "player 9 at cycle 104: UNKNOWN: no ball");
}

TEST(Check, FailureIncludesLastOutputLine) {
  RunRecord run = record();
  run.result.end_reason = match::EndReason::kRefused;
  run.result.message = "left (run:x): its process ended before it answered: exit code 1";
  run.result.failure =
      match::ProcessFailure{"left Playmaker", "exit code 1", "", {"in line 3", "no module"}};
  EXPECT_EQ(failure({EndCheck{match::EndReason::kFinished}, "", 1, {}}, run),
            "the run ended as refused, not finished: left (run:x): its process ended before it "
            "answered: exit code 1; last output line: no module");
}

TEST(Check, ComparesGoldenValues) {
  EXPECT_EQ(ask(R"({"golden": "score"})", {{"score", "1 : 0 at step 10"}}), "");
  EXPECT_EQ(ask(R"({"golden": "score"})", {{"score", "0 : 0 at step 10"}}),
            "score is 1 : 0 at step 10, golden value is 0 : 0 at step 10");
  EXPECT_EQ(ask(R"({"golden": "touches"})"),
            "no golden value accepted yet; found 2 left 9, 5 right 2, 7 left 9");
  EXPECT_EQ(ask(R"({"golden": "game_log"})", {{"game_log", "d5c9ae190ac1afc8"}}),
            "game_log is " + fingerprint({"game_log", ""}, record()) +
                ", golden value is d5c9ae190ac1afc8");
}

TEST(Check, EvaluatesUntilConditions) {
  const auto holds = [](const std::string& text, int step) {
    const JsonDocument json = *JsonDocument::parse("s.json", text);
    const auto test = parse_step_test(JsonValue(json));
    EXPECT_TRUE(test) << test.error().message;
    const RunRecord run = record();
    return test->holds(run.frames.at(static_cast<std::size_t>(step)), run);
  };
  EXPECT_TRUE(holds(R"({"goals": 1})", 8));
  EXPECT_FALSE(holds(R"({"goals": 1})", 7));
  EXPECT_TRUE(holds(R"({"touch_by": "right"})", 5));
  EXPECT_FALSE(holds(R"({"touch_by": "right"})", 2));
  EXPECT_TRUE(holds(R"({"player": "left 9", "is": {"x": {">": 0}}})", 3));
}

}  // namespace
}  // namespace cls::scenario
