// Reading coach and trainer commands with the leniency and the errors of the real server.
#include "soccer/commands/coach_command.h"

#include <algorithm>
#include <array>

#include "soccer/commands/clang_frame.h"
#include "soccer/commands/player_command_lexer.h"
#include "soccer/commands/xpm.h"
#include "soccer/protocol/loose_scanner.h"
#include "soccer/side.h"

namespace cls::soccer {
namespace {

using Reply = std::optional<ErrorCode>;

constexpr std::size_t kMaxWordSize = 127;
constexpr std::size_t kMaxSwitchSize = 15;

bool is_command_character(char c) {
  return is_say_character(c) && c != ' ' && c != '(' && c != ')';
}
bool is_not_blank(char c) { return !LooseScanner::is_blank(c); }
bool is_switch_character(char c) { return c != ' ' && c != '(' && c != ')'; }
bool is_not_closing(char c) { return c != ')'; }

template <typename Command>
Reply plain(LooseScanner&, CoachCommand& out) {
  out = Command{};
  return std::nullopt;
}

// "on" or "off"; the rest of the datagram is not looked at.
template <typename Command>
Reply on_off(LooseScanner& in, CoachCommand& out) {
  const std::string_view word = in.run(is_switch_character, kMaxSwitchSize);
  if (word != "on" && word != "off") return ErrorCode::kIllegalCommandForm;
  out = Command{word == "on"};
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
  change.team = in.run(is_not_blank, kMaxWordSize);
  if (change.team.empty() || !in.integer(change.unum) || !in.integer(change.type)) {
    return ErrorCode::kIllegalCommandForm;
  }
  out = std::move(change);
  return std::nullopt;
}

Reply coach_say(LooseScanner& in, CoachCommand& out) {
  std::optional<CoachSay> said = read_clang_say(in.rest());
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

Reply team_graphic(LooseScanner& in, CoachCommand& out) {
  auto& graphic = out.emplace<TeamGraphic>();
  if (!(in.token("(") && in.integer(graphic.x) && in.integer(graphic.y))) {
    return ErrorCode::kIllegalCommandForm;
  }
  in.skip_to('"');
  if (!read_xpm(in.rest(), graphic.xpm)) return ErrorCode::kInvalidXpmData;
  return std::nullopt;
}

Reply change_mode(LooseScanner& in, CoachCommand& out) {
  const std::string_view word = in.run(is_command_character, kMaxWordSize);
  if (word.empty()) return ErrorCode::kIllegalCommandForm;
  const std::optional<PlayMode> mode = play_mode_from_name(word);
  if (!mode || *mode == PlayMode::kNull) return ErrorCode::kIllegalMode;
  out = ChangeMode{*mode};
  return std::nullopt;
}

// The numbers behind an object: X Y, then nothing, an angle, or an angle and a velocity.
Reply read_placement(LooseScanner& in, Vec2& position, std::optional<double>& angle,
                     std::optional<Vec2>& velocity) {
  if (!in.number(position.x) || !in.number(position.y)) return ErrorCode::kIllegalObjectForm;
  double value = 0.0;
  if (!in.number(value)) return std::nullopt;
  angle = value;
  Vec2 speed;
  if (!in.number(speed.x)) return std::nullopt;
  if (!in.number(speed.y)) return ErrorCode::kIllegalCommandForm;
  velocity = speed;
  return std::nullopt;
}

Reply move(LooseScanner& in, CoachCommand& out) {
  if (!in.token("(")) return ErrorCode::kIllegalObjectForm;
  LooseScanner object(in.run(is_not_closing, kMaxWordSize));
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
  command.team = object.run(is_not_blank, kMaxWordSize);
  if (command.team.empty() || !object.integer(command.unum) || command.unum < 1 ||
      command.unum > kPlayersPerTeam) {
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
    {"team_names", kCoach | kTrainer, plain<AskTeamNames>},
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
  const std::string_view word = in.run(is_command_character, kMaxWordSize);
  if (word.empty()) return ErrorCode::kIllegalCommandForm;
  const unsigned wanted = role == CoachRole::kOnlineCoach ? kCoach : kTrainer;
  for (const Entry& entry : kEntries) {
    if (entry.name == word && (entry.roles & wanted) != 0) return entry.read(in, out);
  }
  return ErrorCode::kUnknownCommand;
}

}  // namespace cls::soccer
