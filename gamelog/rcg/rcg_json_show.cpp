// Parses the shows of JSON logs: 22 players with up to 36 named values each.
#include "gamelog/rcg/rcg_json_show.h"

#include <array>
#include <cstdint>
#include <string>
#include <variant>

#include "base/index.h"
#include "gamelog/record/record_builder.h"

namespace cls::gamelog {
namespace {

using soccer::Side;

struct ReadPlayer {
  PlayerFrame frame;
  Side side = Side::kNeutral;
  int unum = 0;
  bool points = false;
  soccer::Vec2 pointing_at;
};

/// Where a value is stored; its type tells how it is read.
using Target = std::variant<double*, int*, std::uint32_t*, bool*, Side*>;

struct Member {
  std::string_view name;
  Target (*target)(ReadPlayer& player);
};

// In the order of rcssserver.
constexpr std::array kMembers = std::to_array<Member>({
    {"side", [](ReadPlayer& p) -> Target { return &p.side; }},
    {"unum", [](ReadPlayer& p) -> Target { return &p.unum; }},
    {"type", [](ReadPlayer& p) -> Target { return &p.frame.type; }},
    {"state", [](ReadPlayer& p) -> Target { return &p.frame.state; }},
    {"x", [](ReadPlayer& p) -> Target { return &p.frame.position.x; }},
    {"y", [](ReadPlayer& p) -> Target { return &p.frame.position.y; }},
    {"vx", [](ReadPlayer& p) -> Target { return &p.frame.velocity.x; }},
    {"vy", [](ReadPlayer& p) -> Target { return &p.frame.velocity.y; }},
    {"body", [](ReadPlayer& p) -> Target { return &p.frame.body; }},
    {"neck", [](ReadPlayer& p) -> Target { return &p.frame.neck; }},
    {"px", [](ReadPlayer& p) -> Target { return p.points = true, &p.pointing_at.x; }},
    {"py", [](ReadPlayer& p) -> Target { return &p.pointing_at.y; }},
    {"vq", [](ReadPlayer& p) -> Target { return &p.frame.high_quality; }},
    {"vw", [](ReadPlayer& p) -> Target { return &p.frame.view_width; }},
    {"fdist", [](ReadPlayer& p) -> Target { return &p.frame.focus_distance; }},
    {"fdir", [](ReadPlayer& p) -> Target { return &p.frame.focus_direction; }},
    {"stamina", [](ReadPlayer& p) -> Target { return &p.frame.stamina; }},
    {"effort", [](ReadPlayer& p) -> Target { return &p.frame.effort; }},
    {"recovery", [](ReadPlayer& p) -> Target { return &p.frame.recovery; }},
    {"capacity", [](ReadPlayer& p) -> Target { return &p.frame.capacity; }},
    {"fside", [](ReadPlayer& p) -> Target { return &p.frame.attention_side; }},
    {"fnum", [](ReadPlayer& p) -> Target { return &p.frame.attention_unum; }},
    {"kick", [](ReadPlayer& p) -> Target { return &p.frame.counts.kick; }},
    {"dash", [](ReadPlayer& p) -> Target { return &p.frame.counts.dash; }},
    {"turn", [](ReadPlayer& p) -> Target { return &p.frame.counts.turn; }},
    {"catch", [](ReadPlayer& p) -> Target { return &p.frame.counts.catches; }},
    {"move", [](ReadPlayer& p) -> Target { return &p.frame.counts.move; }},
    {"turn_neck", [](ReadPlayer& p) -> Target { return &p.frame.counts.turn_neck; }},
    {"change_view", [](ReadPlayer& p) -> Target { return &p.frame.counts.change_view; }},
    {"say", [](ReadPlayer& p) -> Target { return &p.frame.counts.say; }},
    {"tackle", [](ReadPlayer& p) -> Target { return &p.frame.counts.tackle; }},
    {"pointto", [](ReadPlayer& p) -> Target { return &p.frame.counts.pointto; }},
    {"attentionto", [](ReadPlayer& p) -> Target { return &p.frame.counts.attentionto; }},
    {"change_focus", [](ReadPlayer& p) -> Target { return &p.frame.counts.change_focus; }},
});

constexpr std::string_view kNestedCounters = "count";

// Index of a member; the number of all if there is none of that name. Starts at the expected one,
// because they usually follow in this order.
std::size_t find_member(std::string_view name, std::size_t expected) {
  for (std::size_t i = 0; i < kMembers.size(); ++i) {
    const std::size_t at = (expected + i) % kMembers.size();
    if (kMembers[at].name == name) return at;
  }
  return kMembers.size();
}

bool read_value(base::JsonCursor& in, double& value) { return in.number(value); }
bool read_value(base::JsonCursor& in, int& value) { return in.integer(value); }
bool read_value(base::JsonCursor& in, Side& side) { return read_side(in, side); }
bool read_value(base::JsonCursor& in, std::uint32_t& state) {
  int value = 0;
  if (!in.integer(value)) return false;
  state = static_cast<std::uint32_t>(value);
  return true;
}
bool read_value(base::JsonCursor& in, bool& high_quality) {
  std::string text;
  if (!in.string(text)) return false;
  high_quality = text != "l";
  return true;
}

// Parses the members of a player. Server 17 nests the counters in an object.
bool read_player_fields(base::JsonCursor& in, ReadPlayer& player, bool within_counts) {
  std::size_t expected = 0;
  std::string_view name;

  while (in.next_key(name)) {
    if (name == kNestedCounters && !within_counts) {
      if (!in.open('{') || !read_player_fields(in, player, true)) return false;
      continue;
    }

    const std::size_t found = find_member(name, expected);
    expected = found + 1;
    const bool read = found == kMembers.size()
                          ? in.skip_value()
                          : std::visit([&in](auto* value) { return read_value(in, *value); },
                                       kMembers[found].target(player));
    if (!read) return false;
  }

  return in.good();
}

bool is_possible(const ReadPlayer& player) {
  const PlayerFrame& frame = player.frame;
  const bool attention =
      frame.attention_side == Side::kNeutral || soccer::is_unum(frame.attention_unum);
  return player.side != Side::kNeutral && soccer::is_unum(player.unum) && frame.type >= -1 &&
         frame.type <= kMaxPlayerType && attention;
}

bool read_players(base::JsonCursor& in, Frame& frame) {
  if (!in.open('[')) return false;

  while (in.next_element()) {
    ReadPlayer player;
    player.frame.capacity = -1.0;

    if (!in.open('{') || !read_player_fields(in, player, false) || !is_possible(player))
      return false;

    if (player.points) player.frame.pointing_at = player.pointing_at;
    frame.players[base::index(soccer::slot_of(player.side, player.unum))] = player.frame;
  }

  return in.good();
}

bool read_ball(base::JsonCursor& in, Frame& frame) {
  std::string_view key;
  if (!in.open('{')) return false;

  while (in.next_key(key)) {
    if (key == "z" && !frame.ball_height) frame.ball_height = 0.0;
    double* value = key == "x"    ? &frame.ball_position.x
                    : key == "y"  ? &frame.ball_position.y
                    : key == "vx" ? &frame.ball_velocity.x
                    : key == "vy" ? &frame.ball_velocity.y
                    : key == "z"  ? &*frame.ball_height
                                  : nullptr;
    if (!(value == nullptr ? in.skip_value() : in.number(*value))) return false;
  }

  return in.good();
}

}  // namespace

bool read_side(base::JsonCursor& in, Side& side) {
  std::string text;
  if (!in.string(text)) return false;
  side = text == "l" ? Side::kLeft : text == "r" ? Side::kRight : Side::kNeutral;
  return true;
}

bool read_json_show(base::JsonCursor& in, Frame& frame) {
  constexpr int kMaxStopped = 1'000'000'000;
  frame = Frame{};
  std::string_view key;

  while (in.next_key(key)) {
    const bool read = key == "time"      ? in.integer(frame.time)
                      : key == "stime"   ? in.integer(frame.stopped)
                      : key == "ball"    ? read_ball(in, frame)
                      : key == "players" ? read_players(in, frame)
                                         : in.skip_value();
    if (!read) return false;
  }

  return in.good() && frame.time >= 0 && frame.stopped >= 0 && frame.stopped <= kMaxStopped;
}

}  // namespace cls::gamelog
