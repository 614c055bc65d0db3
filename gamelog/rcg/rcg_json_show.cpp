// Parses the shows of JSON logs: 22 players with up to 36 named values each.
#include "gamelog/rcg/rcg_json_show.h"

#include <array>
#include <cstdint>
#include <string>

#include "gamelog/record/record_builder.h"

namespace cls::gamelog {
namespace {

using soccer::Side;

enum class PlayerKey : std::uint8_t {
  kSide,
  kUnum,
  kType,
  kState,
  kX,
  kY,
  kVx,
  kVy,
  kBody,
  kNeck,
  kPointX,
  kPointY,
  kQuality,
  kWidth,
  kFocusDistance,
  kFocusDirection,
  kStamina,
  kEffort,
  kRecovery,
  kCapacity,
  kAttentionSide,
  kAttentionUnum,
  kKick,
  kDash,
  kTurn,
  kCatch,
  kMove,
  kTurnNeck,
  kChangeView,
  kSay,
  kTackle,
  kPointto,
  kAttentionto,
  kChangeFocus,
};

// In the order of rcssserver.
constexpr std::array kPlayerKeys = std::to_array<std::string_view>(
    {"side",        "unum", "type",    "state",   "x",           "y",           "vx",
     "vy",          "body", "neck",    "px",      "py",          "vq",          "vw",
     "fdist",       "fdir", "stamina", "effort",  "recovery",    "capacity",    "fside",
     "fnum",        "kick", "dash",    "turn",    "catch",       "move",        "turn_neck",
     "change_view", "say",  "tackle",  "pointto", "attentionto", "change_focus"});

constexpr std::string_view kNestedCounters = "count";

// Starts at the expected key, because keys usually follow in this order.
std::size_t find_key(std::string_view key, std::size_t expected) {
  for (std::size_t i = 0; i < kPlayerKeys.size(); ++i) {
    const std::size_t at = (expected + i) % kPlayerKeys.size();
    if (kPlayerKeys[at] == key) return at;
  }

  return kPlayerKeys.size();
}

struct ReadPlayer {
  PlayerFrame frame;
  Side side = Side::kNeutral;
  int unum = 0;
  bool points = false;
  soccer::Vec2 pointing_at;
};

int* counter(PlayerKey key, CommandCounts& c) {
  const std::array<int*, 12> counters = {&c.kick,   &c.dash,      &c.turn,        &c.catches,
                                         &c.move,   &c.turn_neck, &c.change_view, &c.say,
                                         &c.tackle, &c.pointto,   &c.attentionto, &c.change_focus};
  return counters[static_cast<std::size_t>(key) - static_cast<std::size_t>(PlayerKey::kKick)];
}

double* real(PlayerKey key, ReadPlayer& player) {
  PlayerFrame& frame = player.frame;
  switch (key) {
    case PlayerKey::kX:
      return &frame.position.x;
    case PlayerKey::kY:
      return &frame.position.y;
    case PlayerKey::kVx:
      return &frame.velocity.x;
    case PlayerKey::kVy:
      return &frame.velocity.y;
    case PlayerKey::kBody:
      return &frame.body;
    case PlayerKey::kNeck:
      return &frame.neck;
    case PlayerKey::kPointX:
      return &player.pointing_at.x;
    case PlayerKey::kPointY:
      return &player.pointing_at.y;
    case PlayerKey::kWidth:
      return &frame.view_width;
    case PlayerKey::kFocusDistance:
      return &frame.focus_distance;
    case PlayerKey::kFocusDirection:
      return &frame.focus_direction;
    case PlayerKey::kStamina:
      return &frame.stamina;
    case PlayerKey::kEffort:
      return &frame.effort;
    case PlayerKey::kRecovery:
      return &frame.recovery;
    default:
      return &frame.capacity;
  }
}

bool read_state(base::JsonCursor& in, std::uint32_t& state) {
  int value = 0;
  if (!in.integer(value)) return false;
  state = static_cast<std::uint32_t>(value);
  return true;
}

bool read_player_value(base::JsonCursor& in, PlayerKey key, ReadPlayer& player) {
  std::string text;
  switch (key) {
    case PlayerKey::kSide:
      return read_side(in, player.side);
    case PlayerKey::kUnum:
      return in.integer(player.unum);
    case PlayerKey::kType:
      return in.integer(player.frame.type);
    case PlayerKey::kState:
      return read_state(in, player.frame.state);
    case PlayerKey::kQuality:
      if (!in.string(text)) return false;
      player.frame.high_quality = text != "l";
      return true;
    case PlayerKey::kAttentionSide:
      return read_side(in, player.frame.attention_side);
    case PlayerKey::kAttentionUnum:
      return in.integer(player.frame.attention_unum);
    case PlayerKey::kPointX:
      player.points = true;
      break;
    default:
      break;
  }

  if (key >= PlayerKey::kKick) return in.integer(*counter(key, player.frame.counts));
  return in.number(*real(key, player));
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

    const std::size_t found = find_key(name, expected);
    expected = found + 1;
    const bool read = found == kPlayerKeys.size()
                          ? in.skip_value()
                          : read_player_value(in, static_cast<PlayerKey>(found), player);

    if (!read) return false;
  }

  return in.good();
}

bool is_possible(const ReadPlayer& player) {
  const PlayerFrame& frame = player.frame;
  const bool attention =
      frame.attention_side == Side::kNeutral ||
      (frame.attention_unum >= 1 && frame.attention_unum <= soccer::kPlayersPerTeam);
  return player.side != Side::kNeutral && player.unum >= 1 &&
         player.unum <= soccer::kPlayersPerTeam && frame.type >= -1 &&
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
    frame.players[static_cast<std::size_t>(soccer::slot_of(player.side, player.unum))] =
        player.frame;
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
    bool read = false;
    if (key == "time") {
      read = in.integer(frame.time);
    } else if (key == "stime") {
      read = in.integer(frame.stopped);
    } else if (key == "ball") {
      read = read_ball(in, frame);
    } else if (key == "players") {
      read = read_players(in, frame);
    } else {
      read = in.skip_value();
    }

    if (!read) return false;
  }

  return in.good() && frame.time >= 0 && frame.stopped >= 0 && frame.stopped <= kMaxStopped;
}

}  // namespace cls::gamelog
