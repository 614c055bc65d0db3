// Score, field, time line and keys.
#include "viewer/terminal/match_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "gamelog/record/frame.h"
#include "viewer/terminal/field_picture.h"

namespace cls::viewer {
namespace {

constexpr std::array<double, 9> kSpeeds = {0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50};
constexpr int kHeadRows = 1;
constexpr int kFootRows = 2;

/// The bytes that terminals send for a key, and the frames that it moves by.
struct KeyRow {
  Key key;
  std::array<std::string_view, 4> bytes;
  double step = 0.0;
};

constexpr KeyRow kKeys[] = {
    {Key::kPlay, {" "}},
    {Key::kBack, {"\x1b[D", "\x1bOD"}, -1},
    {Key::kForward, {"\x1b[C", "\x1bOC"}, 1},
    {Key::kBackTen, {"\x1b[B", "\x1bOB", "\x1b[1;2D"}, -10},
    {Key::kForwardTen, {"\x1b[A", "\x1bOA", "\x1b[1;2C"}, 10},
    {Key::kStart, {"\x1b[H", "\x1bOH", "\x1b[1~", "\x1b[7~"}},
    {Key::kEnd, {"\x1b[F", "\x1bOF", "\x1b[4~", "\x1b[8~"}},
    {Key::kSlower, {","}},
    {Key::kFaster, {"."}},
    {Key::kNextGoal, {"g"}},
    {Key::kPreviousGoal, {"G"}},
    {Key::kLive, {"N"}},
    {Key::kQuit, {"q", "Q", "\x03"}},
};

std::string team_name(const gamelog::TeamFrame& team, const char* otherwise) {
  return team.name.empty() ? otherwise : team.name;
}

std::string score_text(const gamelog::Frame& frame) {
  const auto& [left, right] = frame.teams;
  std::string text = fmt::format("{} {} : {} {}", team_name(left, "left"), left.score, right.score,
                                 team_name(right, "right"));
  if (left.penalties_taken() + right.penalties_taken() > 0) {
    text += fmt::format("  penalties {} : {}", left.penalty_scored, right.penalty_scored);
  }
  return text;
}

std::string clock_text(const gamelog::Frame& frame) {
  const std::string stopped = frame.stopped > 0 ? fmt::format("+{}", frame.stopped) : "";
  return fmt::format("{}{}", frame.time, stopped);
}

// The length of the escape sequence at the start of `bytes`; 0 if it is not complete.
std::size_t sequence_length(std::string_view bytes) {
  if (bytes[0] != '\x1b') return 1;
  if (bytes.size() < 2) return 0;
  if (bytes[1] != '[' && bytes[1] != 'O') return 1;

  for (std::size_t i = 2; i < bytes.size(); ++i) {
    if (bytes[i] >= '@' && bytes[i] <= '~') return i + 1;
  }
  return 0;
}

}  // namespace

std::vector<Key> take_keys(std::string& bytes) {
  std::vector<Key> keys;
  while (!bytes.empty()) {
    const std::size_t length = sequence_length(bytes);
    if (length == 0) break;

    const auto known = std::ranges::find_if(kKeys, [&](const KeyRow& row) {
      return std::ranges::find(row.bytes, bytes.substr(0, length)) != row.bytes.end();
    });
    if (known != std::end(kKeys)) keys.push_back(known->key);
    bytes.erase(0, length);
  }
  return keys;
}

std::size_t MatchScreen::last() const { return record_.frames() == 0 ? 0 : record_.frames() - 1; }

std::size_t MatchScreen::frame() const { return std::min(last(), static_cast<std::size_t>(at_)); }

bool MatchScreen::at_end() const {
  return playing_ && !live_ && at_ >= static_cast<double>(last());
}

void MatchScreen::set_live(bool live) {
  if (live && !live_) following_ = true;
  live_ = live;
  if (!live) following_ = false;
}

void MatchScreen::seek(std::size_t frame) {
  following_ = false;
  at_ = static_cast<double>(std::min(frame, last()));
}

void MatchScreen::step(double frames) {
  playing_ = false;
  following_ = false;
  at_ = std::clamp(std::floor(at_) + frames, 0.0, static_cast<double>(last()));
}

void MatchScreen::press(Key key) {
  switch (key) {
    case Key::kPlay:
      if (at_end()) at_ = 0.0;
      playing_ = following_ ? false : !playing_;
      following_ = false;
      break;

    case Key::kBack:
    case Key::kForward:
    case Key::kBackTen:
    case Key::kForwardTen:
      return step(std::ranges::find(kKeys, key, &KeyRow::key)->step);
    case Key::kStart:
      return step(-at_);
    case Key::kEnd:
      return step(static_cast<double>(last()));

    case Key::kSlower:
      if (speed_ > 0) --speed_;
      break;
    case Key::kFaster:
      speed_ = std::min(speed_ + 1, kSpeeds.size() - 1);
      break;

    case Key::kNextGoal:
      return find_goal(1);
    case Key::kPreviousGoal:
      return find_goal(-1);

    case Key::kLive:
      following_ = live_;
      playing_ = playing_ || live_;
      break;
    case Key::kQuit:
      quit_ = true;
      break;
  }
}

void MatchScreen::find_goal(int direction) {
  const auto score = [&](std::size_t frame) {
    const auto& teams = gamelog::teams_at(record_, frame);
    return teams[0].score + teams[1].score;
  };

  for (std::size_t i = frame(); direction > 0 ? i < last() : i > 1;) {
    direction > 0 ? ++i : --i;
    if (score(i) > score(i - 1)) return seek(i);
  }
}

void MatchScreen::advance(double seconds) {
  const auto end = static_cast<double>(last());
  if (following_) {
    at_ = end;
  } else if (playing_) {
    const double step_ms = std::max(1, record_.server.simulator_step);
    at_ = std::min(end, at_ + seconds * 1000.0 / step_ms * kSpeeds[speed_]);
    following_ = live_ && at_ >= end;
  }
}

std::string MatchScreen::line() const {
  if (record_.frames() == 0) return "waiting for the kick-off";
  const gamelog::Frame frame = frame_at(record_, this->frame());
  return fmt::format("cycle {}, {}, {}", clock_text(frame), name(frame.mode), score_text(frame));
}

Screen MatchScreen::draw(int columns, int rows, bool color) const {
  Screen screen(columns, rows);
  if (record_.frames() == 0) {
    screen.write(rows / 2, std::max(0, columns / 2 - 12), "waiting for the kick-off");
    return screen;
  }

  draw_head(screen);
  const int field_rows = rows - kHeadRows - kFootRows;
  if (field_rows > 0) {
    draw_field(frame_at(record_, frame()), {kHeadRows, field_rows, !color}, screen);
  }
  draw_foot(screen);
  return screen;
}

void MatchScreen::draw_head(Screen& screen) const {
  const gamelog::Frame frame = frame_at(record_, this->frame());
  const auto& [left, right] = frame.teams;

  int column = 1;
  const auto append = [&](std::string_view text, Ink ink) {
    screen.write(0, column, text, ink);
    column += static_cast<int>(text.size()) + 1;
  };

  append(team_name(left, "left"), Ink::kLeft);
  append(fmt::format("{} : {}", left.score, right.score), Ink::kBold);
  append(team_name(right, "right"), Ink::kRight);
  if (left.penalties_taken() + right.penalties_taken() > 0) {
    append(fmt::format(" penalties {} : {}", left.penalty_scored, right.penalty_scored),
           Ink::kPlain);
  }

  const std::string clock = fmt::format("{}  {}", name(frame.mode), clock_text(frame));
  const int start = std::max(column, screen.columns() - static_cast<int>(clock.size()) - 1);
  screen.write(0, start, clock, Ink::kBold);
}

void MatchScreen::draw_foot(Screen& screen) const {
  const int width = screen.columns() - 2;
  const double share =
      last() == 0 ? 0.0 : static_cast<double>(frame()) / static_cast<double>(last());
  const int cursor = static_cast<int>(share * std::max(0, width - 1));

  const int row = screen.rows() - kFootRows;
  for (int i = 0; i < width; ++i) {
    screen.put(row, 1 + i, {i == cursor ? "┃" : "─", i <= cursor ? Ink::kBold : Ink::kDim, false});
  }

  const std::string state = following_ ? "LIVE" : playing_ ? "play" : "pause";
  std::string text = fmt::format("{:5} {:g}x  space pause  arrows step  , . speed  g goal", state,
                                 kSpeeds[speed_]);
  if (live_) text += "  N live";
  screen.write(screen.rows() - 1, 1, text + "  q quit", Ink::kDim);
}

}  // namespace cls::viewer
