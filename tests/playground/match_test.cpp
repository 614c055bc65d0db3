// Matches of the playground have the bytes of `cls match`, and functions decide for teams.
#include "playground/match.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "analysis/situations/book.h"
#include "match/run_match.h"
#include "proto/status_name.h"
#include "tests/support/error_of.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "viewer/decisions/decision_files.h"
#include "viewer/decisions/decision_reader.h"

namespace cls::playground {
namespace {

using google::protobuf::Message;
using proto::Rpc;
using proxy::RpcStatus;
using testing::HasSubstr;
using tests::error_of;

constexpr int kCycles = 120;

MatchSetup setup_of(const std::string& left, const std::string& right) {
  MatchSetup setup;
  setup.sides = {left, right};
  setup.seed = 7;
  setup.cycles = kCycles;
  return setup;
}

struct Logs {
  std::string game;
  std::string text;
  soccer::PerSide<std::string> decisions;  // if the setup asks for them, without latencies
};

// A recording without what differs from run to run.
std::string comparable(const std::string& stream) {
  const auto decisions = viewer::without_latencies(stream);
  EXPECT_TRUE(decisions) << decisions.error().message;
  return decisions ? *decisions : "";
}

// What `cls match` writes for the same setup.
Logs logs_of_cls_match(const MatchSetup& setup) {
  const tests::TemporaryFolder folder;
  match::MatchOptions options;
  options.left = *match::parse_endpoint(setup.sides.left);
  options.right = *match::parse_endpoint(setup.sides.right);
  options.names = setup.names;
  options.seed = setup.seed;
  options.cycles = setup.cycles;
  options.folder = folder.path() / "match";
  options.record_world_models = setup.decisions;
  for (const std::string& setting : setup.settings) {
    EXPECT_TRUE(match::apply_setting(options, setting));
  }
  if (setup.book != nullptr) {
    options.book = "given";
    options.loaded_book = setup.book;
    options.situations = setup.situations;
  }

  match::MatchObserver no_observer;
  const std::atomic<int> no_signal{0};
  const auto result = match::run_match(options, no_observer, no_signal);
  EXPECT_TRUE(result) << result.error().message;
  Logs logs = {tests::read_file(options.folder / "match.rcg"),
               tests::read_file(options.folder / "match.rcl"),
               {}};
  if (setup.decisions) {
    logs.decisions = {comparable(tests::read_file(options.folder / viewer::kLeftWorldModelsFile)),
                      comparable(tests::read_file(options.folder / viewer::kRightWorldModelsFile))};
  }
  return logs;
}

// The logs of a match, taken in pieces.
Logs logs_of(Match& match) {
  Logs logs;
  bool plays = true;
  while (plays) {
    plays = match.play(7);
    logs.game += match.take_game_log();
    logs.text += match.take_text_log();
    for (const soccer::Side side : soccer::kBothSides) {
      logs.decisions[side] += match.take_decisions(side);
    }
  }
  return logs;
}

void expect_same_bytes(const MatchSetup& setup) {
  auto match = Match::create(setup);
  ASSERT_TRUE(match) << match.error().message;
  const Logs logs = logs_of(**match);
  const Logs expected = logs_of_cls_match(setup);

  EXPECT_GT(logs.game.size(), 100'000U);
  EXPECT_GT(logs.text.size(), 10'000U);
  EXPECT_TRUE(logs.game == expected.game);
  EXPECT_TRUE(logs.text == expected.text);
  EXPECT_EQ((*match)->failure(), "");
}

TEST(PlaygroundMatch, HasTheBytesOfAMatchOfPlanners) {
  expect_same_bytes(setup_of("mock:planner", "mock:planner"));
}

TEST(PlaygroundMatch, HasTheBytesOfAMatchWithNamesAndSettings) {
  MatchSetup setup = setup_of("mock:simple", "mock");
  setup.names = {"Blue", "Red"};
  setup.settings = {"server::half_time=5", "server::game_log_version=5", "player::pt_max=2"};
  expect_same_bytes(setup);
}

// Two attacks: the ball rolls toward the right goal in front of a row of players of each side.
std::shared_ptr<const analysis::Book> attacks() {
  constexpr int kWarmUp = 2;
  analysis::Book book;
  book.warm_up = kWarmUp;
  book.logs.push_back({"match.rcg", {"a", "b"}, std::vector<soccer::PlayerType>(2)});
  book.logs[0].types[1].player_speed_max = 0.9;
  for (int i = 0; i < 2; ++i) {
    analysis::Situation situation;
    for (std::size_t slot = 0; slot < situation.players.size(); ++slot) {
      situation.players[slot] = {slot == 4 ? 1 : 0, 3000.0, 0.9, 0.8, 100'000.0};
    }
    for (int step = 0; step <= kWarmUp; ++step) {
      analysis::BookFrame frame;
      frame.ball = {30.0 + i + 0.5 * step, 0.0};
      frame.ball_velocity = {0.5, 0.0};
      for (std::size_t slot = 0; slot < frame.players.size(); ++slot) {
        const bool left = slot < soccer::kPlayersPerTeam;
        const double row = static_cast<double>(slot % soccer::kPlayersPerTeam) - 5.0;
        frame.players[slot] = {{left ? 28.0 : 40.0, 3.0 * row}, {}, left ? 0.0 : 180.0};
      }
      situation.frames.push_back(frame);
    }
    book.situations.push_back(situation);
  }
  return std::make_shared<const analysis::Book>(std::move(book));
}

TEST(PlaygroundMatch, HasTheBytesOfAMatchOfSituations) {
  MatchSetup setup = setup_of("mock:planner", "mock:simple");
  setup.book = attacks();
  setup.situations = 2;
  setup.cycles = 40;
  expect_same_bytes(setup);
}

TEST(PlaygroundMatch, HasTheDecisionsThatAMatchRecords) {
  MatchSetup setup = setup_of("mock:planner", "mock:simple");
  setup.cycles = 60;
  setup.decisions = true;
  auto match = Match::create(setup);
  ASSERT_TRUE(match) << match.error().message;
  const Logs logs = logs_of(**match);
  const Logs expected = logs_of_cls_match(setup);

  for (const soccer::Side side : soccer::kBothSides) {
    EXPECT_GT(logs.decisions[side].size(), 10'000U);
    EXPECT_TRUE(comparable(logs.decisions[side]) == expected.decisions[side]);
  }
}

TEST(PlaygroundMatch, HasNoDecisionsUnlessTheSetupAsksForThem) {
  MatchSetup setup = setup_of("mock:simple", "mock:simple");
  setup.cycles = 3;
  auto match = Match::create(setup);
  ASSERT_TRUE(match);
  EXPECT_EQ(logs_of(**match).decisions.left, "");
}

TEST(PlaygroundMatch, ChangesNothingWhenItIsOver) {
  MatchSetup setup = setup_of("mock:hold", "mock:hold");
  setup.cycles = 3;
  auto match = Match::create(setup);
  ASSERT_TRUE(match);
  logs_of(**match);

  EXPECT_TRUE((*match)->over());
  EXPECT_FALSE((*match)->play(10));
  EXPECT_EQ((*match)->take_game_log(), "");
  EXPECT_EQ((*match)->world().clock.time, 3);
}

// Holds the ball, as mock:hold does; counts its decisions.
struct HoldingTeam {
  int decisions = 0;
  int registered = 0;

  RpcStatus answer(Rpc rpc, Message& reply) {
    if (rpc == Rpc::kRegister) {
      static_cast<protos::RegisterResponse&>(reply).set_client_id(++registered);
    }
    if (rpc != Rpc::kGetPlayerActions) return {};
    ++decisions;
    static_cast<protos::PlayerActions&>(reply).add_actions()->mutable_dash()->set_power(100);
    return {};
  }
};

TEST(PlaygroundMatch, AsksAFunctionForTheDecisionsOfATeam) {
  MatchSetup setup = setup_of("function", "mock:simple");
  setup.cycles = 20;
  HoldingTeam team;
  auto match = Match::create(
      setup,
      {[&](Rpc rpc, const Message&, Message& reply) { return team.answer(rpc, reply); }, {}});
  ASSERT_TRUE(match) << match.error().message;
  logs_of(**match);

  EXPECT_EQ(team.registered, 12) << "11 players and the coach";
  EXPECT_GE(team.decisions, 11 * 20);
  EXPECT_EQ((*match)->failure(), "");
  const simulator::Player& forward = (*match)->world().player(10);
  EXPECT_GT(forward.counters.dash, 10);
}

TEST(PlaygroundMatch, EndsWhenAFunctionFailsTooOftenInARow) {
  MatchSetup setup = setup_of("mock:hold", "function");
  HoldingTeam team;
  const auto fail = [&](Rpc rpc, const Message&, Message& reply) -> RpcStatus {
    if (rpc != Rpc::kGetPlayerActions) return team.answer(rpc, reply);
    return proxy::rpc_status(rpc, proto::kStatusUnknown, "TypeError: no (team.js:3)");
  };
  auto match = Match::create(setup, {{}, fail});
  ASSERT_TRUE(match) << match.error().message;
  logs_of(**match);

  EXPECT_TRUE((*match)->over());
  EXPECT_LT((*match)->world().clock.time, kCycles);
  EXPECT_THAT((*match)->failure(),
              HasSubstr("function: player 1 had no usable reply to 21 calls in a row"));
  EXPECT_EQ(kMaxMissed, match::MatchOptions().max_missed);
  EXPECT_THAT((*match)->failure(), HasSubstr("TypeError: no (team.js:3)"));
  EXPECT_THAT((*match)->take_warnings(), testing::Contains(HasSubstr("TypeError")));
}

TEST(PlaygroundMatch, NamesWhatIsWrong) {
  EXPECT_THAT(error_of(Match::create(setup_of("mock:plannr", "mock"))), HasSubstr("planner"));
  EXPECT_THAT(error_of(Match::create(setup_of("mock", "run:./team"))),
              HasSubstr("unknown side 'run:./team': must be mock, mock:NAME or function"));
  EXPECT_EQ(error_of(Match::create(setup_of("function", "mock"))),
            "side 'function' has no function");

  MatchSetup setup = setup_of("mock", "mock");
  setup.settings = {"server::half_tim=5"};
  EXPECT_THAT(error_of(Match::create(setup)), HasSubstr("half_time"));
  setup.settings = {"server::game_log_version=3"};
  setup.view = true;
  EXPECT_THAT(error_of(Match::create(setup)), HasSubstr("game log of version 4 to 6"));
  setup = setup_of("mock", "mock");
  setup.names.right = "two words";
  EXPECT_THAT(error_of(Match::create(setup)), HasSubstr("team name 'two words'"));
}

}  // namespace
}  // namespace cls::playground
