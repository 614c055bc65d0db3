// Formats the lines of text game logs.
#include "gamelog/rcg/rcg_text.h"

#include <algorithm>

#include "base/text/number_text.h"
#include "soccer/math.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/parameters/parameter.h"
#include "soccer/protocol/text_writer.h"

namespace cls::gamelog {
namespace {

using soccer::TextWriter;

constexpr double kLengthStep = 0.0001;
constexpr double kAngleStep = 0.001;

void append_number(double value, TextWriter& out) {
  out += ' ';
  out.append_number(value);
}

void append_count(int value, TextWriter& out) {
  out += ' ';
  out.append_number(value);
}

void append_lengths(soccer::Vec2 v, TextWriter& out) {
  append_number(soccer::math::quantize(v.x, kLengthStep), out);
  append_number(soccer::math::quantize(v.y, kLengthStep), out);
}

void append_angle(double degrees, TextWriter& out) {
  append_number(soccer::math::quantize(degrees, kAngleStep), out);
}

void append_state(std::uint32_t state, TextWriter& out) {
  if (state == 0) {
    out += " 0";
    return;
  }

  out += " 0x";
  constexpr std::string_view kDigits = "0123456789abcdef";

  int shift = 28;
  while ((state >> shift) == 0) shift -= 4;
  for (; shift >= 0; shift -= 4) out += kDigits[(state >> shift) & 0xF];
}

void append_counts(const CommandCounts& c, RcgVersion version, TextWriter& out) {
  out += " (c";
  for (const int count : {c.kick, c.dash, c.turn, c.catches, c.move, c.turn_neck, c.change_view,
                          c.say, c.tackle, c.pointto, c.attentionto}) {
    append_count(count, out);
  }

  if (version >= RcgVersion::kV6) append_count(c.change_focus, out);
  out += ')';
}

void append_view(const PlayerFrame& player, RcgVersion version, TextWriter& out) {
  out += player.high_quality ? " (v h" : " (v l";
  append_number(player.view_width, out);
  out += ')';

  if (version < RcgVersion::kV6) return;

  out += " (fp";
  append_number(soccer::math::quantize(player.focus_distance, kLengthStep), out);
  append_number(soccer::math::quantize(player.focus_direction, kLengthStep), out);
  out += ')';
}

void append_stamina(const PlayerFrame& player, RcgVersion version, TextWriter& out) {
  out += " (s";
  append_number(player.stamina, out);
  append_number(player.effort, out);
  append_number(player.recovery, out);
  if (version >= RcgVersion::kV5) append_number(player.capacity, out);
  out += ')';
}

void append_player(int slot, const PlayerFrame& player, RcgVersion version, TextWriter& out) {
  out += " ((";
  out += soccer::letter(soccer::side_of_slot(slot));
  append_count(soccer::unum_of_slot(slot), out);
  out += ')';

  append_count(player.type, out);
  append_state(player.state, out);
  append_lengths(player.position, out);
  append_lengths(player.velocity, out);
  append_angle(player.body, out);
  append_angle(player.neck, out);

  if (player.pointing_at) append_lengths(*player.pointing_at, out);
  append_view(player, version, out);
  append_stamina(player, version, out);

  if (player.attention_side != soccer::Side::kNeutral && (player.state & kStateEnabled) != 0) {
    out += " (f ";
    out += soccer::letter(player.attention_side);
    append_count(player.attention_unum, out);
    out += ')';
  }

  append_counts(player.counts, version, out);
  out += ')';
}

void append_frame(const Frame& frame, RcgVersion version, TextWriter& out) {
  out += " ((b)";
  append_lengths(frame.ball_position, out);
  append_lengths(frame.ball_velocity, out);
  if (version == RcgVersion::kV7) {
    append_number(soccer::math::quantize(frame.ball_height.value_or(0.0), kLengthStep), out);
  }
  out += ')';

  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    append_player(slot, frame.players[static_cast<std::size_t>(slot)], version, out);
  }
}

}  // namespace

void append_version(RcgVersion version, std::string& out) {
  out += "ULG";
  base::append_int(static_cast<int>(version), out);
  out += '\n';
}

void append_header(RcgVersion version, const soccer::ServerParams& server,
                   const soccer::PlayerParams& player, const std::vector<soccer::PlayerType>& types,
                   std::string& out) {
  append_version(version, out);
  soccer::format(server, soccer::kAllVersions, out);
  out += '\n';
  soccer::format(player, soccer::kAllVersions, out);
  out += '\n';

  for (const soccer::PlayerType& type : types) {
    soccer::format(type, soccer::kAllVersions, out);
    out += '\n';
  }
}

void append_play_mode(int time, soccer::PlayMode mode, std::string& text) {
  TextWriter out(text);
  out += "(playmode";
  append_count(time, out);
  out += ' ';
  out += soccer::name(mode);
  out += ")\n";
}

void append_team(int time, const TeamFrames& teams, std::string& text) {
  TextWriter out(text);
  out += "(team";
  append_count(time, out);

  for (const TeamFrame& team : teams) {
    out += ' ';
    out += team.name.empty() ? std::string_view("null") : std::string_view(team.name);
  }

  for (const TeamFrame& team : teams) append_count(team.score, out);
  if (teams[0].penalties_taken() > 0 || teams[1].penalties_taken() > 0) {
    for (const TeamFrame& team : teams) {
      append_count(team.penalty_scored, out);
      append_count(team.penalty_missed, out);
    }
  }

  out += ")\n";
}

void append_show(const Frame& frame, std::string& text, RcgVersion version) {
  TextWriter out(text);
  out += "(show";
  append_count(frame.time, out);
  append_frame(frame, version, out);
  out += ")\n";
}

void append_objects(const Frame& frame, std::string& text, RcgVersion version) {
  TextWriter out(text);
  append_frame(frame, version, out);
}

void append_message(int time, int board, std::string_view text, std::string& out) {
  out += "(msg ";
  base::append_int(time, out);
  out += ' ';
  base::append_int(board, out);
  out += " \"";

  const std::size_t begin = out.size();
  out += text;
  std::replace(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(), '\n', ' ');

  out += "\")\n";
}

}  // namespace cls::gamelog
