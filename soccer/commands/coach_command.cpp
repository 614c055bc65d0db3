// Parsers of coach and trainer commands, as lenient as rcssserver and with its errors.
#include "soccer/commands/coach_command.h"

#include <algorithm>
#include <array>

#include "base/index.h"
#include "soccer/commands/clang_frame.h"
#include "soccer/commands/player_command_lexer.h"
#include "soccer/protocol/loose_scanner.h"
#include "soccer/protocol/text_writer.h"
#include "soccer/side.h"

namespace cls::soccer {
namespace {

using Reply = std::optional<ErrorCode>;

constexpr std::size_t kMaxTokenSize = 127;
constexpr std::size_t kMaxSwitchSize = 15;

bool is_command_character(char c) {
  return is_say_character(c) && c != ' ' && c != '(' && c != ')';
}
bool is_not_space(char c) { return !LooseScanner::is_space(c); }
bool is_switch_character(char c) { return c != ' ' && c != '(' && c != ')'; }
bool is_not_closing(char c) { return c != ')'; }

template <typename Command>
Reply plain(LooseScanner&, CoachCommand& out) {
  out = Command{};
  return std::nullopt;
}

// "on" or "off"; ignores the rest of the datagram.
template <typename Command>
Reply on_off(LooseScanner& in, CoachCommand& out) {
  const std::string_view token = in.run(is_switch_character, kMaxSwitchSize);
  if (token != "on" && token != "off") return ErrorCode::kIllegalCommandForm;
  out = Command{token == "on"};
  return std::nullopt;
}

Reply compression(LooseScanner& in, CoachCommand& out) {
  int level = 0;
  if (!in.integer(level)) return ErrorCode::kIllegalCommandForm;
  out = Compression{level};
  return std::nullopt;
}

Reply change_player_type(LooseScanner& in, CoachCommand& out) {
  ChangePlayerType change;
  if (!in.integer(change.unum)) return ErrorCode::kIllegalCommandForm;

  int type = 0;
  if (in.integer(type)) {
    change.type = type;
  } else if (!in.run(is_switch_character, kMaxSwitchSize).starts_with("goalie")) {
    return ErrorCode::kIllegalCommandForm;
  }

  out = change;
  return std::nullopt;
}

Reply trainer_change_player_type(LooseScanner& in, CoachCommand& out) {
  TrainerChangePlayerType change;
  change.team = in.run(is_not_space, kMaxTokenSize);
  if (change.team.empty() || !in.integer(change.unum) || !in.integer(change.type)) {
    return ErrorCode::kIllegalCommandForm;
  }

  out = std::move(change);
  return std::nullopt;
}

Reply coach_say(LooseScanner& in, CoachCommand& out) {
  std::optional<CoachSay> said = parse_clang_say(in.rest());
  if (!said) return ErrorCode::kCouldNotParseSay;
  out = std::move(*said);
  return std::nullopt;
}

Reply trainer_say(LooseScanner& in, CoachCommand& out) {
  std::string_view text = in.run(is_say_character, std::string_view::npos);
  if (text.ends_with(')')) text.remove_suffix(1);
  if (text.empty()) return ErrorCode::kIllegalCommandForm;
  out = TrainerSay{std::string(text)};
  return std::nullopt;
}

constexpr int kMaxXpmLines = 4096;
constexpr int kMaxXpmWidth = 8191;

struct XpmHeader {
  int width = 0;
  int height = 0;
  int colors = 0;
  int characters_per_pixel = 0;
};

bool read_xpm_header(LooseScanner& in, XpmHeader& header) {
  if (!(in.token("\"") && in.integer(header.width) && in.integer(header.height) &&
        in.integer(header.colors) && in.integer(header.characters_per_pixel) && in.token("\""))) {
    return false;
  }

  const auto in_range = [](int value, int limit) { return value >= 0 && value <= limit; };
  return in_range(header.width, kMaxXpmWidth) && in_range(header.height, kMaxXpmLines) &&
         in_range(header.colors, kMaxXpmLines) &&
         in_range(header.characters_per_pixel, kMaxXpmWidth);
}

bool read_xpm_line(LooseScanner& in, std::vector<std::string>& out) {
  if (!in.token("\"")) return false;

  const std::string_view rest = in.rest();
  const std::size_t length = rest.find('"');
  if (length == std::string_view::npos || length == 0) return false;

  out.emplace_back(rest.substr(0, length));
  in.skip_to('"');
  return in.token("\"");
}

// An X PixMap: quoted lines "W H COLORS CPP", COLORS lines of colors, H lines of W * CPP
// characters. Stores the lines without quotes, and the header with single spaces.
bool parse_xpm(std::string_view text, std::vector<std::string>& out) {
  out.clear();

  LooseScanner in(text);
  XpmHeader header;
  if (!read_xpm_header(in, header)) return false;
  append(out.emplace_back(), header.width, ' ', header.height, ' ', header.colors, ' ',
         header.characters_per_pixel);

  for (int i = 0; i < header.colors; ++i) {
    if (!read_xpm_line(in, out)) return false;
  }

  const std::size_t line_size =
      base::index(header.width) * base::index(header.characters_per_pixel);
  for (int i = 0; i < header.height; ++i) {
    if (!read_xpm_line(in, out) || out.back().size() != line_size) return false;
  }

  return true;
}

Reply team_graphic(LooseScanner& in, CoachCommand& out) {
  auto& graphic = out.emplace<TeamGraphic>();
  if (!(in.token("(") && in.integer(graphic.x) && in.integer(graphic.y))) {
    return ErrorCode::kIllegalCommandForm;
  }

  in.skip_to('"');
  if (!parse_xpm(in.rest(), graphic.xpm)) return ErrorCode::kInvalidXpmData;
  return std::nullopt;
}

Reply change_mode(LooseScanner& in, CoachCommand& out) {
  const std::string_view token = in.run(is_command_character, kMaxTokenSize);
  if (token.empty()) return ErrorCode::kIllegalCommandForm;

  const std::optional<PlayMode> mode = parse_play_mode(token);
  if (!mode || *mode == PlayMode::kNull) return ErrorCode::kIllegalMode;

  out = ChangeMode{*mode};
  return std::nullopt;
}

// The numbers after an object: X Y, optionally an angle, optionally a velocity.
Reply read_placement(LooseScanner& in, Vec2& position, std::optional<double>& angle,
                     std::optional<Vec2>& velocity) {
  if (!in.number(position.x) || !in.number(position.y)) return ErrorCode::kIllegalObjectForm;

  double value = 0.0;
  if (!in.number(value)) return std::nullopt;
  angle = value;

  Vec2 v;
  if (!in.number(v.x)) return std::nullopt;
  if (!in.number(v.y)) return ErrorCode::kIllegalCommandForm;

  velocity = v;
  return std::nullopt;
}

Reply move(LooseScanner& in, CoachCommand& out) {
  if (!in.token("(")) return ErrorCode::kIllegalObjectForm;

  LooseScanner object(in.run(is_not_closing, kMaxMoveObjectSize));
  if (!in.token(")")) return ErrorCode::kIllegalObjectForm;

  if (object.rest() == "ball") {
    MoveBall command;
    const Reply error = read_placement(in, command.position, command.angle, command.velocity);
    out = command;
    return error;
  }

  MovePlayer command;
  const Reply error = read_placement(in, command.position, command.angle, command.velocity);
  if (error == ErrorCode::kIllegalObjectForm) return error;

  if (!object.token("player")) return ErrorCode::kIllegalObjectForm;
  command.team = object.run(is_not_space, kMaxTokenSize);
  if (command.team.empty() || !object.integer(command.unum) || !is_unum(command.unum)) {
    return ErrorCode::kIllegalObjectForm;
  }

  out = std::move(command);
  return error;
}

constexpr unsigned kCoach = 1;
constexpr unsigned kTrainer = 2;

struct Entry {
  std::string_view name;
  unsigned roles;
  Reply (*read)(LooseScanner& in, CoachCommand& out);
};

constexpr std::array kEntries = std::to_array<Entry>({
    {"look", kCoach | kTrainer, plain<Look>},
    {"eye", kCoach | kTrainer, on_off<Eye>},
    {"ear", kTrainer, on_off<TrainerEar>},
    {"team_names", kCoach | kTrainer, plain<RequestTeamNames>},
    {"check_ball", kCoach | kTrainer, plain<CheckBall>},
    {"change_player_type", kCoach, change_player_type},
    {"change_player_type", kTrainer, trainer_change_player_type},
    {"say", kCoach, coach_say},
    {"say", kTrainer, trainer_say},
    {"team_graphic", kCoach, team_graphic},
    {"start", kTrainer, plain<Start>},
    {"change_mode", kTrainer, change_mode},
    {"move", kTrainer, move},
    {"recover", kTrainer, plain<Recover>},
    {"done", kCoach | kTrainer, plain<Done>},
    {"bye", kCoach, plain<Bye>},
    {"compression", kCoach | kTrainer, compression},
});

}  // namespace

std::string_view CoachSay::freeform() const {
  if (kind != ClangKind::kFreeform) return {};

  const std::string_view all = text;
  const std::size_t first = all.find('"');
  const std::size_t last = all.rfind('"');
  return first < last ? all.substr(first + 1, last - first - 1) : std::string_view();
}

std::optional<ErrorCode> parse(std::string_view datagram, CoachRole role, CoachCommand& out) {
  LooseScanner in(datagram);
  if (!in.token("(")) return ErrorCode::kIllegalCommandForm;

  const std::string_view token = in.run(is_command_character, kMaxTokenSize);
  if (token.empty()) return ErrorCode::kIllegalCommandForm;
  const unsigned wanted = role == CoachRole::kOnlineCoach ? kCoach : kTrainer;

  for (const Entry& entry : kEntries) {
    if (entry.name == token && (entry.roles & wanted) != 0) return entry.read(in, out);
  }

  return ErrorCode::kUnknownCommand;
}

}  // namespace cls::soccer
