// A match in characters: what is drawn, what keys do, what reaches the terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/text/json.h"
#include "gamelog/record/record_builder.h"
#include "tests/gamelog/recorded_match.h"
#include "viewer/terminal/asciinema_cast.h"
#include "viewer/terminal/field_picture.h"
#include "viewer/terminal/match_screen.h"

namespace cls::viewer {
namespace {

using gamelog::Frame;
using testing::HasSubstr;
using testing::Not;

Frame frame_with(int time) {
  Frame frame;
  frame.time = time;
  frame.mode = soccer::PlayMode::kPlayOn;
  frame.teams[0].name = "left";
  frame.teams[1].name = "right";
  return frame;
}

void place(Frame& frame, std::size_t slot, double x, double y) {
  frame.players[slot].state = gamelog::kStateEnabled;
  frame.players[slot].position = {x, y};
}

// Ten frames; a goal in the fifth.
gamelog::MatchRecord short_match() {
  gamelog::MatchRecord record;
  gamelog::RecordBuilder builder(record);
  for (int time = 1; time <= 10; ++time) {
    Frame frame = frame_with(time);
    frame.teams[0].score = time >= 5 ? 1 : 0;
    builder.append_frame(frame);
  }
  return record;
}

TEST(FieldPicture, HasEveryThingWhereItIs) {
  Frame frame = frame_with(1);
  frame.ball_position = {0, 0};
  place(frame, 0, -50, 0);
  place(frame, 10, -40, -30);
  place(frame, 11, 50, 0);
  place(frame, 20, 40, 30);
  Screen colored(80, 20);
  draw_field(frame, {0, 20, false}, colored);
  Screen letters(80, 20);
  draw_field(frame, {0, 20, true}, letters);
  const auto cell = [](auto& screen, int row, int column) { return screen.at(row, column).text; };

  EXPECT_EQ(cell(colored, 10, 40), "●");
  // 160 by 80 dots for 110 by 70 meters: 80 / 70 dots a meter.
  EXPECT_EQ(cell(colored, 10, 11), "1");
  EXPECT_EQ(colored.at(10, 11).ink, Ink::kLeft);
  EXPECT_EQ(cell(colored, 1, 17), "B");
  EXPECT_EQ(cell(colored, 10, 68), "1");
  EXPECT_EQ(colored.at(10, 68).ink, Ink::kRight);
  EXPECT_EQ(cell(letters, 10, 11), "A");
  EXPECT_EQ(cell(letters, 1, 17), "K");
  EXPECT_EQ(cell(letters, 10, 68), "a");
  EXPECT_EQ(cell(letters, 18, 62), "j");
}

TEST(FieldPicture, ReversesThePlayerOnTheBallAndHidesAbsentOnes) {
  Frame frame = frame_with(1);
  frame.ball_position = {10, 10};
  place(frame, 6, 10, 10);
  Screen screen(80, 20);
  draw_field(frame, {0, 20, false}, screen);
  int players = 0;
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 80; ++column) {
      const Cell& cell = screen.at(row, column);
      if (cell.ink != Ink::kLeft && cell.ink != Ink::kRight) continue;
      ++players;
      EXPECT_EQ(cell.text, "7");
      EXPECT_TRUE(cell.reverse);
    }
  }

  EXPECT_EQ(players, 1);
}

TEST(FieldPicture, SurvivesAnySizeAndPlace) {
  Frame frame = frame_with(1);
  frame.ball_position = {1e6, -1e6};
  place(frame, 3, -1e5, 1e5);
  for (const int size : {1, 2, 7, 300}) {
    Screen screen(size, size);
    draw_field(frame, {0, size, false}, screen);
    draw_field(frame, {size, 0, false}, screen);
    EXPECT_EQ(screen.rows(), size);
  }
}

TEST(MatchScreen, PlaysInRealTime) {
  const auto record = short_match();
  MatchScreen match(record);
  EXPECT_EQ(match.line(), "cycle 1, play_on, left 0 : 0 right");

  match.advance(0.35);
  EXPECT_EQ(match.frame(), 3U);

  match.press(Key::kFaster);
  match.advance(0.1);
  EXPECT_EQ(match.frame(), 5U);
  EXPECT_EQ(match.line(), "cycle 6, play_on, left 1 : 0 right");

  match.press(Key::kPlay);
  match.advance(1);
  EXPECT_EQ(match.frame(), 5U);

  match.press(Key::kPlay);
  match.advance(9);
  EXPECT_EQ(match.frame(), 9U);
  EXPECT_TRUE(match.at_end());

  match.press(Key::kPlay);
  EXPECT_EQ(match.frame(), 0U);
}

TEST(MatchScreen, ObeysKeys) {
  const auto record = short_match();
  MatchScreen match(record);
  const auto after = [&](Key key) {
    match.press(key);
    return match.frame();
  };

  EXPECT_EQ(after(Key::kForward), 1U);
  EXPECT_FALSE(match.playing());
  EXPECT_EQ(after(Key::kBack), 0U);
  EXPECT_EQ(after(Key::kBack), 0U);
  EXPECT_EQ(after(Key::kForwardTen), 9U);
  EXPECT_EQ(after(Key::kStart), 0U);
  EXPECT_EQ(after(Key::kNextGoal), 4U);
  EXPECT_EQ(after(Key::kNextGoal), 4U);
  EXPECT_EQ(after(Key::kEnd), 9U);
  EXPECT_EQ(after(Key::kPreviousGoal), 4U);
  EXPECT_EQ(after(Key::kLive), 4U);
  EXPECT_FALSE(match.has_quit());

  match.press(Key::kQuit);
  EXPECT_TRUE(match.has_quit());
}

TEST(MatchScreen, FollowsALiveMatch) {
  gamelog::MatchRecord record;
  MatchScreen match(record);
  match.set_live(true);

  EXPECT_EQ(match.line(), "waiting for the kick-off");
  EXPECT_THAT(match.draw(80, 24, true).text(), HasSubstr("waiting for the kick-off"));

  record = short_match();
  match.advance(0);
  EXPECT_EQ(match.frame(), 9U);

  match.press(Key::kBackTen);
  match.advance(1);
  EXPECT_EQ(match.frame(), 0U);

  match.press(Key::kLive);
  match.advance(0);
  EXPECT_EQ(match.frame(), 9U);
  EXPECT_FALSE(match.at_end());

  match.set_live(false);
  EXPECT_TRUE(match.at_end());
}

TEST(MatchScreen, ShowsScoreClockAndMode) {
  const auto record = tests::record_of("rcg-v6-excerpt");
  MatchScreen match(record);
  for (const auto& [columns, rows] : {std::pair(80, 24), {200, 60}, {30, 8}, {1, 1}}) {
    const std::string text = match.draw(columns, rows, false).text();
    EXPECT_EQ(std::ranges::count(text, '\n'), rows);
    if (columns < 80) continue;
    EXPECT_THAT(text.substr(0, text.find('\n')), HasSubstr(" : "));
    EXPECT_THAT(text, HasSubstr("q quit"));
  }
}

TEST(Screen, LetsNoEscapeSequenceThrough) {
  Screen screen(20, 1);
  screen.write(0, 0, "a\x1b[31m\x9b\n\xff");
  EXPECT_EQ(screen.text(), "a?[31m???\n");
}

TEST(Screen, UpdatesOnlyWhatChanged) {
  Screen before(80, 24);
  Screen after = before;
  after.write(3, 5, "xy", Ink::kLeft);
  const std::string update = after.update(&before, true);
  EXPECT_THAT(update, HasSubstr("\x1b[4;6H\x1b[0;1;38;5;75mxy"));
  EXPECT_LT(update.size(), 60U);
  EXPECT_GT(after.update(nullptr, true).size(), 80U * 24U);
  const std::string plain = after.update(&before, false);
  EXPECT_THAT(plain, Not(HasSubstr("38;5")));
  EXPECT_THAT(plain, HasSubstr("xy"));
}

TEST(Keys, AreReadWholeInAnyPieces) {
  std::string bytes = " \x1b[C\x1bOD\x1b[1;2Czq\x1b[";
  EXPECT_EQ(take_keys(bytes), (std::vector<Key>{Key::kPlay, Key::kForward, Key::kBack,
                                                Key::kForwardTen, Key::kQuit}));
  EXPECT_EQ(bytes, "\x1b[");
  bytes += "A";
  EXPECT_EQ(take_keys(bytes), std::vector<Key>{Key::kForwardTen});
  EXPECT_EQ(bytes, "");
}

TEST(Cast, IsJsonByLines) {
  const auto header = base::Json::parse(cast_header(80, 24, "a\"b"));
  EXPECT_EQ(header["version"], 2);
  EXPECT_EQ(header["width"], 80);
  EXPECT_EQ(header["title"], "a\"b");
  EXPECT_EQ(cast_line(1.23456, "\x1b[H●"), "[1.235,\"o\",\"\\u001b[H●\"]\n");
}

}  // namespace
}  // namespace cls::viewer
