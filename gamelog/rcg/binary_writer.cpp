// Binary records; shows of logs are parts of those sent to monitors of versions 1 and 2.
#include "gamelog/rcg/binary_writer.h"

#include <algorithm>
#include <cmath>

#include "base/index.h"
#include "gamelog/rcg/binary_format.h"
#include "soccer/math.h"

namespace cls::gamelog {
namespace {

using namespace rcg_binary;

// Bytes.
constexpr std::size_t kShortSize = 2052;  // datagrams to version 1 monitors
constexpr std::size_t kLongSize = 2056;   // datagrams to version 2 monitors
constexpr std::size_t kMaxText = 2047;
constexpr std::size_t kMaxMessage = 2048;
constexpr std::size_t kLongObjectsOffset = 44;  // of ball and players in a version 2 datagram

/// Appends the fields of a datagram to a string.
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
  /// Truncated or padded to `size`.
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

// Positions outside the range of the field, which only a trainer can set, are clamped.
int rounded(double value) {
  return static_cast<int>(std::rint(std::clamp(value, -32768.0, 32767.0)));
}

// The field has sixteen bits: those of fouls, cards and illegal defense are left out.
int low_bits(std::uint32_t state) { return static_cast<int>(state & 0xffff); }

void add_short_object(int state, int side, int unum, int angle, soccer::Vec2 position,
                      Datagram& datagram) {
  for (const int value : {state, side, unum, angle, rounded(position.x * kShortScale),
                          rounded(position.y * kShortScale)}) {
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

Kind kind_of(const soccer::ServerParams&) { return kServerParam; }
Kind kind_of(const soccer::PlayerParams&) { return kPlayerParam; }
Kind kind_of(const soccer::PlayerType&) { return kType; }

}  // namespace

void append_short_show(const Frame& frame, std::string& out) {
  Datagram datagram(kShow, out);
  add_head(frame, datagram);
  add_short_object(0, 0, 0, 0, frame.ball_position, datagram);

  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    const PlayerFrame& player = frame.players[base::index(slot)];
    add_short_object(low_bits(player.state), soccer::sign(soccer::side_of_slot(slot)),
                     soccer::unum_of_slot(slot), rounded(player.body), player.position, datagram);
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

void append_binary_text(int version, int board, std::string_view text, std::string& out) {
  const bool first = version == 1;
  Datagram datagram(kMessage, out);

  if (!first) datagram.int16(0);
  datagram.int16(board);
  datagram.text(text.substr(0, kMaxText), kMaxText + 1);
  datagram.pad_to(first ? kShortSize : kLongSize);
}

template <typename Params>
void append_binary_parameters(const Params& params, std::string& out) {
  Datagram datagram(kind_of(params), out);
  datagram.int16(0);
  write_parameters(params, datagram.bytes());
  datagram.pad_to(kLongSize);
}

template void append_binary_parameters(const soccer::ServerParams&, std::string&);
template void append_binary_parameters(const soccer::PlayerParams&, std::string&);
template void append_binary_parameters(const soccer::PlayerType&, std::string&);

void append_binary_header(RcgVersion version, const soccer::ServerParams& server,
                          const soccer::PlayerParams& player,
                          const std::vector<soccer::PlayerType>& types, std::string& out) {
  if (version == RcgVersion::kV1) return;

  out += "ULG";
  out += static_cast<char>(version);

  if (version == RcgVersion::kV2) return;

  const auto append = [&out](const auto& params) {
    write_int16(kind_of(params), out);
    write_parameters(params, out);
  };
  append(server);
  append(player);
  for (const soccer::PlayerType& type : types) append(type);
}

void append_binary_play_mode(RcgVersion version, soccer::PlayMode mode, std::string& out) {
  if (version != RcgVersion::kV3) return;
  write_int16(kMode, out);
  out += static_cast<char>(mode);
}

void append_binary_teams(RcgVersion version, const TeamFrames& teams, std::string& out) {
  if (version != RcgVersion::kV3) return;
  write_int16(kTeams, out);
  for (const TeamFrame& team : teams) {
    std::string name = team.name;
    name.resize(kNameSize, '\0');
    out += name;
    write_int16(team.score, out);
  }
}

void append_binary_show(RcgVersion version, const Frame& frame, std::string& out) {
  if (version == RcgVersion::kV1) return append_short_show(frame, out);

  const std::size_t start = out.size();
  if (version == RcgVersion::kV2) {
    append_short_show(frame, out);
    out.resize(start + kKindSize + kShortShowSize);
    return;
  }

  append_long_show(frame, out);
  out.erase(start + kKindSize, kLongObjectsOffset - kKindSize);
  out.resize(start + kKindSize + kLongShowSize);
}

void append_binary_message(RcgVersion version, int board, std::string_view text, std::string& out) {
  if (version == RcgVersion::kV1) return append_binary_text(1, board, text, out);

  text = text.substr(0, kMaxMessage);
  if (text.empty()) text = std::string_view("\0", 1);

  write_int16(kMessage, out);
  write_int16(board, out);
  write_int16(static_cast<int>(text.size()), out);
  out += text;
}

}  // namespace cls::gamelog
