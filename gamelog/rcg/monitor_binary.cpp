// Laying out binary messages to monitors.
#include "gamelog/rcg/monitor_binary.h"

#include <algorithm>
#include <cmath>

#include "gamelog/rcg/binary_params.h"
#include "soccer/math.h"

namespace cls::gamelog {
namespace {

enum Kind : int { kShow = 1, kText = 2, kType = 7, kServerParam = 8, kPlayerParam = 9 };

constexpr std::size_t kShortSize = 2052;
constexpr std::size_t kLongSize = 2056;
constexpr std::size_t kNameSize = 16;
constexpr std::size_t kLongestText = 2047;
constexpr double kShortScale = 16.0;

/// A datagram that grows at the end of a text.
class Datagram {
 public:
  Datagram(int kind, std::string& out) : out_(out), start_(out.size()) { int16(kind); }

  void int8(int value) { out_ += static_cast<char>(value); }
  void int16(int value) { write_int16(value, out_); }
  void real(double value) { write_real(value, Rounding::kNearest, out_); }
  void point(soccer::Vec2 value) {
    real(value.x);
    real(value.y);
  }
  /// Cut or padded to `size`.
  void text(std::string_view value, std::size_t size) {
    value = value.substr(0, size);
    out_ += value;
    out_.append(size - value.size(), '\0');
  }
  void pad_to(std::size_t size) { out_.resize(start_ + size, '\0'); }
  std::string& bytes() { return out_; }

 private:
  std::string& out_;
  std::size_t start_;
};

void add_head(const Frame& frame, Datagram& datagram) {
  datagram.int8(static_cast<int>(frame.mode));
  datagram.int8(0);
  for (const TeamFrame& team : frame.teams) {
    datagram.text(team.name, kNameSize);
    datagram.int16(team.score);
  }
}

// A place outside what the field can say, where only a trainer puts things, becomes the nearest.
int rounded(double value) {
  return static_cast<int>(std::rint(std::clamp(value, -32768.0, 32767.0)));
}

// There is room for sixteen; those of fouls, cards and illegal defence are left out.
int low_bits(std::uint32_t state) { return static_cast<int>(state & 0xffff); }

void add_short_object(int state, int side, int unum, int angle, soccer::Vec2 place,
                      Datagram& datagram) {
  for (const int value :
       {state, side, unum, angle, rounded(place.x * kShortScale), rounded(place.y * kShortScale)}) {
    datagram.int16(value);
  }
}

void add_long_player(const PlayerFrame& player, Datagram& datagram) {
  using soccer::math::to_radians;
  datagram.int16(low_bits(player.state));
  datagram.int16(player.type);
  datagram.point(player.position);
  datagram.point(player.velocity);
  datagram.real(to_radians(player.body));
  datagram.real(to_radians(player.neck));
  datagram.real(to_radians(player.view_width));
  datagram.int16(player.high_quality ? 1 : 0);
  datagram.int16(0);
  datagram.real(player.stamina);
  datagram.real(player.effort);
  datagram.real(player.recovery);
  const CommandCounts& c = player.counts;
  for (const int count :
       {c.kick, c.dash, c.turn, c.say, c.turn_neck, c.catches, c.move, c.change_view}) {
    datagram.int16(count);
  }
}

template <typename Params, typename Write>
void add_parameters(Kind kind, const Params& params, Write write, std::string& out) {
  Datagram datagram(kind, out);
  datagram.int16(0);
  write(params, datagram.bytes());
  datagram.pad_to(kLongSize);
}

}  // namespace

void append_short_show(const Frame& frame, std::string& out) {
  Datagram datagram(kShow, out);
  add_head(frame, datagram);
  add_short_object(0, 0, 0, 0, frame.ball_position, datagram);
  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    const PlayerFrame& player = frame.players[static_cast<std::size_t>(slot)];
    const int side = soccer::side_of_slot(slot) == soccer::Side::kLeft ? 1 : -1;
    add_short_object(low_bits(player.state), side, soccer::unum_of_slot(slot), rounded(player.body),
                     player.position, datagram);
  }
  datagram.int16(frame.time);
  datagram.pad_to(kShortSize);
}

void append_long_show(const Frame& frame, std::string& out) {
  Datagram datagram(kShow, out);
  datagram.int16(0);
  add_head(frame, datagram);
  datagram.int16(0);
  datagram.point(frame.ball_position);
  datagram.point(frame.ball_velocity);
  for (const PlayerFrame& player : frame.players) add_long_player(player, datagram);
  datagram.int16(frame.time);
  datagram.pad_to(kLongSize);
}

void append_binary_text(MonitorVersion version, int board, std::string_view text,
                        std::string& out) {
  const bool first = version == MonitorVersion::k1;
  Datagram datagram(kText, out);
  if (!first) datagram.int16(0);
  datagram.int16(board);
  datagram.text(text.substr(0, kLongestText), kLongestText + 1);
  datagram.pad_to(first ? kShortSize : kLongSize);
}

void append_binary_parameters(const soccer::ServerParams& params, std::string& out) {
  add_parameters(kServerParam, params, write_server_params, out);
}

void append_binary_parameters(const soccer::PlayerParams& params, std::string& out) {
  add_parameters(kPlayerParam, params, write_player_params, out);
}

void append_binary_parameters(const soccer::PlayerType& type, std::string& out) {
  add_parameters(kType, type, write_player_type, out);
}

}  // namespace cls::gamelog
