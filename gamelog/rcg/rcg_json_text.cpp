// Formatting the elements of JSON game logs.
#include "gamelog/rcg/rcg_json_text.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "base/index.h"
#include "base/text/number_text.h"
#include "soccer/math.h"
#include "soccer/parameters/parameter.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"
#include "soccer/protocol/text_writer.h"

namespace cls::gamelog {
namespace {

using soccer::append;

constexpr double kLengthStep = 0.0001;
constexpr double kAngleStep = 0.001;
constexpr std::string_view kTeamGraphic = "(team_graphic_";

void append_string(std::string_view text, std::string& out) {
  constexpr std::string_view kHex = "0123456789abcdef";

  out += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      append(out, '\\', c);
    } else if (byte < ' ') {
      append(out, "\\u00", kHex[byte >> 4], kHex[byte & 0xF]);
    } else {
      out += c;
    }
  }

  out += '"';
}

// Appends `"key":`, after a comma unless the object begins here.
void append_key(std::string_view key, std::string& out) {
  if (!out.ends_with('{')) out += ',';
  append_string(key, out);
  out += ':';
}

template <typename Number>
void append_field(std::string_view key, Number value, std::string& out) {
  append_key(key, out);
  append(out, value);
}

void append_length(std::string_view key, double value, std::string& out) {
  append_field(key, soccer::math::quantize(value, kLengthStep), out);
}

void append_angle(std::string_view key, double value, std::string& out) {
  append_field(key, soccer::math::quantize(value, kAngleStep), out);
}

void append_text(std::string_view key, std::string_view value, std::string& out) {
  append_key(key, out);
  append_string(value, out);
}

void begin_object(std::string_view kind, std::string& out) { append(out, "{\"", kind, "\":{"); }

void append_time(int time, int stopped, std::string& out) {
  append_field("time", time, out);
  if (stopped > 0) append_field("stime", stopped, out);
}

void append_counters(const CommandCounts& c, std::string& out) {
  std::size_t counter = 0;
  for (const int count : {c.kick, c.dash, c.turn, c.catches, c.move, c.turn_neck, c.change_view,
                          c.say, c.tackle, c.pointto, c.attentionto, c.change_focus}) {
    append_field(name(static_cast<Counter>(counter++)), count, out);
  }
}

void append_player(int slot, const PlayerFrame& player, JsonShow form, std::string& out) {
  out += '{';

  append_text("side", std::string(1, soccer::letter(soccer::side_of_slot(slot))), out);
  append_field("unum", soccer::unum_of_slot(slot), out);
  append_field("type", player.type, out);
  append_field("state", static_cast<int>(player.state), out);

  append_length("x", player.position.x, out);
  append_length("y", player.position.y, out);
  append_length("vx", player.velocity.x, out);
  append_length("vy", player.velocity.y, out);
  append_angle("body", player.body, out);
  append_angle("neck", player.neck, out);

  if (player.pointing_at) {
    append_length("px", player.pointing_at->x, out);
    append_length("py", player.pointing_at->y, out);
  }

  append_text("vq", player.high_quality ? "h" : "l", out);
  append_field("vw", player.view_width, out);
  if (form == JsonShow::kMonitor) {
    append_length("fdist", player.focus_distance, out);
    append_angle("fdir", player.focus_direction, out);
  }

  append_field("stamina", player.stamina, out);
  append_field("effort", player.effort, out);
  append_field("recovery", player.recovery, out);
  append_field("capacity", player.capacity, out);

  if (player.attention_side != soccer::Side::kNeutral && (player.state & kStateEnabled) != 0) {
    append_text("fside", std::string(1, soccer::letter(player.attention_side)), out);
    append_field("fnum", player.attention_unum, out);
  }

  if (form == JsonShow::kLog) append_counters(player.counts, out);
  out += '}';
}

template <typename Params>
bool is_bool(const soccer::ParameterTable<Params>& table, std::string_view name) {
  const auto* row = soccer::find_parameter(table, name);
  return row != nullptr && std::holds_alternative<bool Params::*>(row->member);
}

void append_teams(const TeamFrames& teams, std::string& out) {
  for (std::size_t i = 0; i < teams.size(); ++i) {
    const TeamFrame& team = teams[i];
    append_key(i == 0 ? "l" : "r", out);
    out += '{';

    append_key("name", out);
    if (team.name.empty()) {
      out += "null";
    } else {
      append_string(team.name, out);
    }

    append_field("score", team.score, out);
    if (team.penalties_taken() > 0) {
      append_field("pen_score", team.penalty_scored, out);
      append_field("pen_miss", team.penalty_missed, out);
    }

    out += '}';
  }
}

bool is_bool(std::string_view kind, std::string_view name) {
  if (kind == "server_param") return is_bool(soccer::server_param_table(), name);
  if (kind == "player_param") return is_bool(soccer::player_param_table(), name);
  return false;
}

// Numbers are copied, except forms that JSON does not allow: "+1", ".5", "05".
bool append_number(std::string_view text, std::string& out) {
  const auto value = base::parse_number(text);
  if (!value) return false;

  const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool zeros = digits.size() > 1 && digits[0] == '0' && is_digit(digits[1]);

  if (is_digit(digits[0]) && !zeros) {
    out += text;
  } else {
    base::append_shortest(*value, out);
  }

  return true;
}

void append_value(std::string_view kind, std::string_view name, std::string_view value,
                  std::string& out) {
  append_key(name, out);

  if (value.size() >= 2 && value.front() == '"' && value.back() == '"') {
    append_string(value.substr(1, value.size() - 2), out);
  } else if (is_bool(kind, name)) {
    out += value == "0" || value == "false" ? "false" : "true";
  } else if (!append_number(value, out)) {
    append_string(value, out);
  }
}

// The quoted strings in a text, without quotes.
std::vector<std::string_view> quoted_strings(std::string_view text) {
  std::vector<std::string_view> found;
  for (;;) {
    const std::size_t open = text.find('"');
    const std::size_t close = open == std::string_view::npos ? open : text.find('"', open + 1);
    if (close == std::string_view::npos) return found;

    found.push_back(text.substr(open + 1, close - open - 1));
    text.remove_prefix(close + 1);
  }
}

// Appends `(team_graphic_l (22 3 "8 8 1 1" ...)`; false if the text is something else.
bool append_team_graphic(std::string_view text, std::string& out) {
  if (!text.starts_with(kTeamGraphic)) return false;
  text.remove_prefix(kTeamGraphic.size());
  if (text.size() < 4 || text.substr(1, 2) != " (") return false;

  const std::string_view side = text.substr(0, 1);
  text.remove_prefix(3);

  int x = 0;
  int y = 0;
  const std::size_t x_size = base::parse_int_prefix(text, x);
  if (x_size == 0 || text.substr(x_size, 1) != " ") return false;
  text.remove_prefix(x_size + 1);
  if (base::parse_int_prefix(text, y) == 0) return false;

  begin_object("team_graphic", out);
  append_text("side", side, out);
  append_field("x", x, out);
  append_field("y", y, out);
  append_key("xpm", out);
  out += '[';

  for (const std::string_view line : quoted_strings(text)) {
    if (!out.ends_with('[')) out += ',';
    append_string(line, out);
  }

  out += "]}}";
  return true;
}

}  // namespace

void append_json_text(std::string_view key, std::string_view value, std::string& out) {
  out += '{';
  append_text(key, value, out);
  out += '}';
}

// Strings in parameter lines are not escaped; each ends at the quote before the next bracket.
void append_json_parameters(std::string_view line, std::string& out) {
  const std::size_t kind_end = std::min(line.find(' '), line.size());
  const std::string_view kind = line.substr(std::min<std::size_t>(1, kind_end), kind_end - 1);

  out += '{';
  append_key(kind, out);
  out += '{';

  line.remove_prefix(kind_end);
  for (;;) {
    const std::size_t open = line.find('(');
    const std::size_t space = open == std::string_view::npos ? open : line.find(' ', open);
    if (space == std::string_view::npos) break;

    const std::string_view name = line.substr(open + 1, space - open - 1);
    line.remove_prefix(space + 1);

    const bool text = line.starts_with('"');
    const std::size_t close = text ? line.find("\")") : line.find(')');
    if (close == std::string_view::npos) break;

    append_value(kind, name, line.substr(0, close + (text ? 1 : 0)), out);
    line.remove_prefix(close + 1);
  }

  out += "}}";
}

void append_json_play_mode(int time, int stopped, soccer::PlayMode mode, std::string& out) {
  begin_object("playmode", out);
  append_time(time, stopped, out);
  append_text("mode", soccer::name(mode), out);
  out += "}}";
}

void append_json_team(int time, int stopped, const TeamFrames& teams, std::string& out) {
  begin_object("team", out);
  append_time(time, stopped, out);
  append_teams(teams, out);
  out += "}}";
}

void append_json_show(const Frame& frame, std::string& out, JsonShow form) {
  begin_object("show", out);
  append_time(frame.time, frame.stopped, out);

  if (form == JsonShow::kMonitor) {
    append_text("mode", soccer::name(frame.mode), out);
    append_key("team", out);
    out += '{';
    append_teams(frame.teams, out);
    out += '}';
  }

  append_key("ball", out);
  out += '{';
  append_length("x", frame.ball_position.x, out);
  append_length("y", frame.ball_position.y, out);
  append_length("vx", frame.ball_velocity.x, out);
  append_length("vy", frame.ball_velocity.y, out);
  if (frame.ball_height) append_length("z", *frame.ball_height, out);
  out += "},\"players\":[";

  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    if (slot > 0) out += ',';
    append_player(slot, frame.players[base::index(slot)], form, out);
  }

  out += "]}}";
}

void append_json_message(int time, int stopped, const Message& message, std::string& out) {
  if (append_team_graphic(message.text, out)) return;

  begin_object("msg", out);
  append_time(time, stopped, out);
  append_field("board", message.board, out);
  append_text("message", message.text, out);
  out += "}}";
}

}  // namespace cls::gamelog
