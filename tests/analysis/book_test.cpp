// Books: files, the choice of moments, the draw of situations, their value.
#include "analysis/situations/book.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "analysis/situations/book_file.h"
#include "analysis/situations/book_fit.h"
#include "analysis/situations/make_book.h"
#include "analysis/situations/situation_value.h"
#include "base/io/byte_sink.h"
#include "gamelog/record/record_builder.h"
#include "tests/support/error_of.h"

namespace cls::analysis {
namespace {

using testing::HasSubstr;

// A book with `each` situations of each class of two logs, one step before each moment.
Book small_book(int each) {
  Book book;
  book.seed = 7;
  book.warm_up = 1;
  for (int log = 0; log < 2; ++log) {
    book.logs.push_back({"match.rcg", {"a", "b"}, std::vector<soccer::PlayerType>(2)});
    for (int i = 0; i < each * static_cast<int>(kSituationClasses); ++i) {
      Situation situation;
      situation.kind = static_cast<SituationClass>(i % static_cast<int>(kSituationClasses));
      situation.log = log;
      situation.time = 100 + i;
      situation.score = {1, 2};
      if (situation.kind == SituationClass::kSetPlay) {
        situation.mode = soccer::PlayMode::kCornerKickLeft;
      }

      situation.players[3] = {1, 4000.25, 1.0, 0.9, 130600.0};

      BookFrame frame;
      frame.ball = {12.3456, -7.0};
      frame.players[21] = {{-3.5, 2.25}, {0.125, -0.25}, -179.5};
      situation.frames = {frame, frame};
      book.situations.push_back(situation);
    }
  }
  return book;
}

std::string written(const Book& book) {
  base::StringSink sink;
  write_book(book, sink);
  return sink.bytes();
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

TEST(BookFile, ReadsWhatItWrites) {
  const std::string text = written(small_book(1));
  const auto read = parse_book(text);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(written(*read), text);
  EXPECT_EQ(read->situations.size(), 2 * kSituationClasses);
  EXPECT_EQ(read->logs[1].types.size(), 2);
  const Situation& situation = read->situations[2];
  EXPECT_EQ(situation.kind, SituationClass::kSetPlay);
  EXPECT_EQ(situation.mode, soccer::PlayMode::kCornerKickLeft);
  EXPECT_DOUBLE_EQ(situation.players[3].stamina, 4000.25);
  EXPECT_DOUBLE_EQ(situation.frames[1].players[21].body, -179.5);
}

TEST(BookFile, NamesLineAndKeyOfAnError) {
  const std::string text = written(small_book(1));
  const auto error = [&](const std::string& what, const std::string& by) {
    return tests::error_of(parse_book(replaced(text, what, by)));
  };

  EXPECT_EQ(error("cls.book/1", "cls.book/9"),
            "line 1: format 'cls.book/9' is unknown; this version reads cls.book/1");
  EXPECT_EQ(error("\"seed\":7", "\"sed\":7"), "line 1: 'seed' is missing");
  EXPECT_EQ(error("\"warm_up\":1", "\"warm_up\":2"),
            "line 2: 'frames' has 2 elements instead of 3");
  EXPECT_EQ(error("\"class\":\"attack\"", "\"class\":\"rest\""),
            "line 2: 'class': 'rest' is not a class of situations");
  EXPECT_EQ(error("\"log\":0", "\"log\":5"), "line 2: 'log': 5 is not between 0 and 1");
  EXPECT_EQ(error("\"mode\":\"play_on\"", "\"mode\":\"time_over\""),
            "line 2: 'mode': a situation cannot begin in time_over");
  EXPECT_EQ(error("12.3456", "1e300"), "line 2: 'frames': 1e+300 is not between -200 and 200");
  EXPECT_EQ(error("[1,4000.25", "[2,4000.25"), "line 2: 'players': 2 is not between 0 and 1");
  EXPECT_EQ(error("\"player_size\":0.3", "\"player_size\":-0.3"),
            "line 1: 'player_size': -0.3 is not between 0 and 200");
  EXPECT_EQ(error("{\"class\"", "{\"clas"), "line 2: not a line of JSON");
  EXPECT_EQ(parse_book("").error().message, "the file is empty");
  EXPECT_EQ(parse_book("ULG6\n").error().message, "line 1: not a book of situations");
  EXPECT_THAT(parse_book(text.substr(0, text.find('\n'))).error().message,
              HasSubstr("no situations"));
}

TEST(BookFile, NamesTheFileOfAnError) {
  EXPECT_THAT(tests::error_of(read_book("/nowhere/moments.book")),
              HasSubstr("/nowhere/moments.book"));
}

TEST(SituationsOfBook, AreThoseOfOneLogAndOfAllClasses) {
  const Book book = small_book(5);
  std::set<int> logs;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    constexpr int kDrawn = kSituationClasses;
    const auto drawn = situations_of(book, seed, kDrawn);
    ASSERT_EQ(drawn.size(), kDrawn);

    std::set<SituationClass> kinds;
    for (const Situation* one : drawn) {
      kinds.insert(one->kind);
      EXPECT_EQ(one->log, drawn.front()->log);
    }

    EXPECT_EQ(kinds.size(), kSituationClasses);

    logs.insert(drawn.front()->log);
    EXPECT_EQ(situations_of(book, seed, kDrawn), drawn);
  }

  EXPECT_EQ(logs.size(), 2);
}

TEST(SituationsOfBook, AreDistinctAndLimitedToThoseOfTheLog) {
  const Book book = small_book(2);
  const auto drawn = situations_of(book, 3, 100);
  EXPECT_EQ(std::set<const Situation*>(drawn.begin(), drawn.end()).size(), drawn.size());
  EXPECT_EQ(drawn.size(), 2 * kSituationClasses);
}

// A match in which the ball is kicked about: by number 9 of the side that has it, `x` meters from
// the middle, for 100 cycles each.
gamelog::MatchRecord ping_pong(int cycles, double x = 35.0) {
  gamelog::MatchRecord record;
  record.types.resize(1);
  gamelog::RecordBuilder builder(record);
  gamelog::Frame frame;
  frame.mode = soccer::PlayMode::kPlayOn;
  frame.teams[0].name = "a";
  frame.teams[1].name = "b";

  for (std::size_t slot = 0; slot < frame.players.size(); ++slot) {
    gamelog::PlayerFrame& player = frame.players[slot];
    player.state = gamelog::kStateEnabled;
    player.position = {slot < 11 ? -40.0 : 40.0, static_cast<double>(slot % 11) * 5 - 25};
    player.capacity = 130600.0;
  }
  frame.players[1].state |= gamelog::kStateGoalie;
  frame.players[11].state |= gamelog::kStateGoalie;

  for (int time = 1; time <= cycles; ++time) {
    frame.time = time;
    const bool left = time / 100 % 2 == 0;
    const std::size_t kicker = left ? 8 : 19;
    frame.ball_position = {left ? x : -x, 0.5 * (time % 2)};
    for (const std::size_t slot : {8U, 19U}) frame.players[slot].state &= ~gamelog::kStateKick;
    gamelog::PlayerFrame& player = frame.players[kicker];
    player.state |= gamelog::kStateKick;
    player.position = frame.ball_position;
    ++player.counts.kick;

    frame.mode = time % 200 >= 150 && time % 200 < 180 ? soccer::PlayMode::kKickInRight
                                                       : soccer::PlayMode::kPlayOn;
    builder.append_frame(frame);
  }
  return record;
}

TEST(BookMaker, FindsMomentsOfEachClassAndBalancesThem) {
  const gamelog::MatchRecord record = ping_pong(2000);
  BookMaker maker({.count = 12, .warm_up = 5});

  ASSERT_EQ(maker.add(record, "a.rcg"), "");
  EXPECT_GT(maker.moments(SituationClass::kAttack), 3);

  const Book book = maker.make();
  std::map<SituationClass, int> counts;
  for (const Situation& one : book.situations) {
    ++counts[one.kind];
    ASSERT_EQ(one.frames.size(), 6);

    const double x = one.frames.back().ball.x;
    EXPECT_TRUE(one.kind != SituationClass::kAttack || x > 30.0) << x;
    EXPECT_TRUE(one.kind != SituationClass::kDefense || x < -30.0) << x;
    EXPECT_EQ(one.mode == soccer::PlayMode::kPlayOn, one.kind != SituationClass::kSetPlay);
    // Number 2 of the left team was its goalie, and is number 1 in the book.
    EXPECT_DOUBLE_EQ(one.frames.back().players[0].position.y, -20.0);
    EXPECT_DOUBLE_EQ(one.frames.back().players[1].position.y, -25.0);
  }

  EXPECT_GE(counts.size(), 3);

  for (const auto& [kind, count] : counts) EXPECT_EQ(count, counts.begin()->second) << name(kind);
}

TEST(BookMaker, TakesTheClassesThatAreChosen) {
  BookMaker maker({.count = 6, .classes = {SituationClass::kBuildUp}, .warm_up = 5});
  ASSERT_EQ(maker.add(ping_pong(2000, 10.0), "a.rcg"), "");
  EXPECT_EQ(maker.moments(SituationClass::kTurnover), 0);

  const Book book = maker.make();
  EXPECT_EQ(book.situations.size(), 6);
  for (const Situation& one : book.situations) {
    EXPECT_EQ(one.kind, SituationClass::kBuildUp);
    EXPECT_EQ(one.mode, soccer::PlayMode::kPlayOn);
  }
}

TEST(BookMaker, GivesTheSameBytesForTheSameSeed) {
  const auto bytes = [](std::uint64_t seed) {
    BookMaker maker({.count = 12, .seed = seed});
    EXPECT_EQ(maker.add(ping_pong(3000), "a.rcg"), "");
    return written(maker.make());
  };
  EXPECT_EQ(bytes(1), bytes(1));
  EXPECT_NE(bytes(1), bytes(2));
}

TEST(BookMaker, LeavesOutMomentsWithoutAllPlayers) {
  gamelog::MatchRecord record = ping_pong(1000);
  for (std::size_t frame = 0; frame < record.frames(); ++frame) {
    record.players.state[frame * gamelog::kSlots + 5] = 0;
  }
  BookMaker maker({});
  EXPECT_THAT(maker.add(record, "a.rcg"), HasSubstr("22 players"));
}

TEST(SituationValue, IsTheOppositeForTheOtherSide) {
  const SituationFigures figures{1.0, 0.5, 0.25, 0.125, 0.5, 0.75, 1.0, 0.25};
  const SituationFigures other{-1.0, -0.5, -0.25, -0.125, -0.5, -0.75, -1.0, -0.25};
  EXPECT_DOUBLE_EQ(situation_value(figures), -situation_value(other));
  EXPECT_GT(situation_value(figures), 0.0);
}

TEST(SituationFigures, ShowBallPossessionAndGoals) {
  gamelog::MatchRecord record = ping_pong(99);
  const Flow flow = build_flow(record);
  const SituationFigures figures = figures_of(flow, 0, record.frames());

  EXPECT_NEAR(figures.mean_ball_x, 35.0 / 52.5, 1e-6);
  EXPECT_DOUBLE_EQ(figures.end_possession, 1.0);
  EXPECT_GT(figures.mean_possession, 0.9);
  EXPECT_NEAR(figures.mean_danger, 1 - 17.5 / 40, 0.01);
  EXPECT_NEAR(figures.end_danger, 1 - 17.5 / 40, 0.01);
  EXPECT_DOUBLE_EQ(figures.goals, 0.0);

  gamelog::MatchRecord scored = ping_pong(50);
  gamelog::Frame frame = frame_at(scored, 49);
  frame.time = 51;
  frame.teams[1].score = 1;
  gamelog::RecordBuilder(scored).append_frame(frame);
  frame.time = 52;
  gamelog::RecordBuilder(scored).append_frame(frame);
  const Flow with_goal = build_flow(scored);
  const SituationFigures after = figures_of(with_goal, 0, scored.frames());

  EXPECT_DOUBLE_EQ(after.goals, -1.0);
  EXPECT_DOUBLE_EQ(after.end_possession, 0.0);
  EXPECT_DOUBLE_EQ(after.end_danger, 0.0);
}

TEST(BookFitter, NeedsMatchesOfSomeLength) {
  BookFitter fitter(100);
  EXPECT_EQ(fitter.add(build_flow(ping_pong(200))), "the match is too short");
  EXPECT_EQ(fitter.add(build_flow(ping_pong(3000))), "");
  EXPECT_EQ(fitter.fit().matches, 1);
}

}  // namespace
}  // namespace cls::analysis
