// A strict parser for lines of rcg version 6.
#include "tests/support/rcg_lines.h"

#include <cstdlib>
#include <stdexcept>

namespace cls::tests {
namespace {

using soccer::Side;

class Scanner {
 public:
  explicit Scanner(std::string_view line) : line_(line) {}

  bool skip(std::string_view text) {
    if (line_.substr(at_, text.size()) != text) return false;
    at_ += text.size();
    return true;
  }
  void expect(std::string_view text) {
    if (!skip(text)) fail("expected '" + std::string(text) + "'");
  }
  /// Up to the next space or closing parenthesis.
  std::string word() {
    const std::size_t end = std::min(line_.find_first_of(" )", at_), line_.size());
    std::string result(line_.substr(at_, end - at_));
    at_ = end;
    if (result.empty()) fail("expected a word");
    return result;
  }
  double number() {
    const std::string text = word();
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end != text.c_str() + text.size()) fail("expected a number");
    return value;
  }
  double next_number() {
    expect(" ");
    return number();
  }
  int next_integer() { return static_cast<int>(next_number()); }
  soccer::Vec2 next_point() {
    const double x = next_number();
    return {x, next_number()};
  }
  Side side() {
    if (skip("l ")) return Side::kLeft;
    if (skip("r ")) return Side::kRight;
    fail("expected a side");
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(why + " at byte " + std::to_string(at_) + " of " +
                             std::string(line_.substr(0, 60)));
  }
  void finish() {
    expect(")");
    if (at_ != line_.size()) fail("expected the end");
  }

 private:
  std::string_view line_;
  std::size_t at_ = 0;
};

void read_player(Scanner& in, gamelog::PlayerFrame& player) {
  player.type = in.next_integer();
  in.expect(" ");
  player.state = static_cast<std::uint32_t>(std::strtoul(in.word().c_str(), nullptr, 16));
  player.position = in.next_point();
  player.velocity = in.next_point();
  player.body = in.next_number();
  player.neck = in.next_number();
  player.pointing_at.reset();

  if (!in.skip(" (v ")) {
    player.pointing_at = in.next_point();
    in.expect(" (v ");
  }

  player.high_quality = in.word() == "h";
  player.view_width = in.next_number();
  in.expect(") (fp");
  player.focus_distance = in.next_number();
  player.focus_direction = in.next_number();
  in.expect(") (s");
  player.stamina = in.next_number();
  player.effort = in.next_number();
  player.recovery = in.next_number();
  player.capacity = in.next_number();
  in.expect(")");
  player.attention_side = Side::kNeutral;
  player.attention_unum = 0;

  if (in.skip(" (f ")) {
    player.attention_side = in.side();
    player.attention_unum = static_cast<int>(in.number());
    in.expect(")");
  }
  in.expect(" (c");
  gamelog::CommandCounts& c = player.counts;
  for (int* count : {&c.kick, &c.dash, &c.turn, &c.catches, &c.move, &c.turn_neck, &c.change_view,
                     &c.say, &c.tackle, &c.pointto, &c.attentionto, &c.change_focus}) {
    *count = in.next_integer();
  }
  in.expect("))");
}

}  // namespace

std::vector<std::string_view> split_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

void read_show(std::string_view line, gamelog::Frame& frame) {
  Scanner in(line);
  in.expect("(show ");
  frame.time = static_cast<int>(in.number());
  in.expect(" ((b)");
  frame.ball_position = in.next_point();
  frame.ball_velocity = in.next_point();
  in.expect(")");
  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    in.expect(" ((");
    const Side side = in.side();
    const int unum = static_cast<int>(in.number());
    in.expect(")");
    if (soccer::slot_of(side, unum) != slot) in.fail("players out of order");
    read_player(in, frame.players[static_cast<std::size_t>(slot)]);
  }
  in.finish();
}

void read_play_mode(std::string_view line, gamelog::Frame& frame) {
  Scanner in(line);
  in.expect("(playmode");
  in.next_integer();
  in.expect(" ");
  const auto mode = soccer::parse_play_mode(in.word());
  if (!mode) in.fail("unknown play mode");
  frame.mode = *mode;
  in.finish();
}

void read_team(std::string_view line, gamelog::Frame& frame) {
  Scanner in(line);
  in.expect("(team");
  in.next_integer();
  for (gamelog::TeamFrame& team : frame.teams) {
    in.expect(" ");
    team.name = in.word();
    if (team.name == "null") team.name.clear();
  }
  for (gamelog::TeamFrame& team : frame.teams) team.score = in.next_integer();
  if (!in.skip(")")) {
    for (gamelog::TeamFrame& team : frame.teams) {
      team.penalty_scored = in.next_integer();
      team.penalty_missed = in.next_integer();
    }
    in.finish();
  }
}

std::vector<gamelog::Frame> read_frames(std::string_view log) {
  std::vector<gamelog::Frame> frames;
  gamelog::Frame frame;
  for (const std::string_view line : split_lines(log)) {
    if (line.starts_with("(playmode ")) read_play_mode(line, frame);
    if (line.starts_with("(team ")) read_team(line, frame);
    if (!line.starts_with("(show ")) continue;
    read_show(line, frame);
    frames.push_back(frame);
  }
  return frames;
}

}  // namespace cls::tests
