// Formats the lines of text game logs.
#include "gamelog/rcg/rcg_text.h"

#include <algorithm>

#include "base/index.h"
#include "soccer/math.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/parameters/parameter.h"
#include "soccer/protocol/text_writer.h"

namespace cls::gamelog {
namespace {

using soccer::append;
using soccer::TextWriter;

constexpr double kLengthStep = 0.0001;
constexpr double kAngleStep = 0.001;

void append_length(double meters, TextWriter& out) {
  append(out, ' ', soccer::math::quantize(meters, kLengthStep));
}

void append_lengths(soccer::Vec2 v, TextWriter& out) {
  append_length(v.x, out);
  append_length(v.y, out);
}

void append_angle(double degrees, TextWriter& out) {
  append(out, ' ', soccer::math::quantize(degrees, kAngleStep));
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
    append(out, ' ', count);
  }

  if (version >= RcgVersion::kV6) append(out, ' ', c.change_focus);
  out += ')';
}

void append_view(const PlayerFrame& player, RcgVersion version, TextWriter& out) {
  append(out, player.high_quality ? " (v h " : " (v l ", player.view_width, ')');
  if (version < RcgVersion::kV6) return;

  out += " (fp";
  append_lengths({player.focus_distance, player.focus_direction}, out);
  out += ')';
}

void append_stamina(const PlayerFrame& player, RcgVersion version, TextWriter& out) {
  append(out, " (s ", player.stamina, ' ', player.effort, ' ', player.recovery);
  if (version >= RcgVersion::kV5) append(out, ' ', player.capacity);
  out += ')';
}

void append_player(int slot, const PlayerFrame& player, RcgVersion version, TextWriter& out) {
  append(out, " ((", soccer::letter(soccer::side_of_slot(slot)), ' ', soccer::unum_of_slot(slot),
         ") ", player.type);
  append_state(player.state, out);
  append_lengths(player.position, out);
  append_lengths(player.velocity, out);
  append_angle(player.body, out);
  append_angle(player.neck, out);

  if (player.pointing_at) append_lengths(*player.pointing_at, out);
  append_view(player, version, out);
  append_stamina(player, version, out);

  if (player.attention_side != soccer::Side::kNeutral && (player.state & kStateEnabled) != 0) {
    append(out, " (f ", soccer::letter(player.attention_side), ' ', player.attention_unum, ')');
  }

  append_counts(player.counts, version, out);
  out += ')';
}

void append_frame(const Frame& frame, RcgVersion version, TextWriter& out) {
  out += " ((b)";
  append_lengths(frame.ball_position, out);
  append_lengths(frame.ball_velocity, out);
  if (version == RcgVersion::kV7) append_length(frame.ball_height.value_or(0.0), out);
  out += ')';

  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    append_player(slot, frame.players[base::index(slot)], version, out);
  }
}

}  // namespace

void append_version(RcgVersion version, std::string& out) {
  append(out, "ULG", static_cast<int>(version), '\n');
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

void append_team_state(const TeamFrames& teams, std::string& out) {
  for (const TeamFrame& team : teams) {
    append(out, ' ', team.name.empty() ? std::string_view("null") : std::string_view(team.name));
  }

  for (const TeamFrame& team : teams) append(out, ' ', team.score);
  if (teams[0].penalties_taken() <= 0 && teams[1].penalties_taken() <= 0) return;
  for (const TeamFrame& team : teams) {
    append(out, ' ', team.penalty_scored, ' ', team.penalty_missed);
  }
}

void append_play_mode(int time, soccer::PlayMode mode, std::string& out) {
  append(out, "(playmode ", time, ' ', soccer::name(mode), ")\n");
}

void append_team(int time, const TeamFrames& teams, std::string& out) {
  append(out, "(team ", time);
  append_team_state(teams, out);
  out += ")\n";
}

void append_show(const Frame& frame, std::string& text, RcgVersion version) {
  TextWriter out(text);
  append(out, "(show ", frame.time);
  append_frame(frame, version, out);
  out += ")\n";
}

void append_objects(const Frame& frame, std::string& text, RcgVersion version) {
  TextWriter out(text);
  append_frame(frame, version, out);
}

void append_message(int time, int board, std::string_view text, std::string& out) {
  append(out, "(msg ", time, ' ', board, " \"");
  const std::size_t begin = out.size();
  out += text;
  std::replace(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(), '\n', ' ');

  out += "\")\n";
}

}  // namespace cls::gamelog
