// Parsers of connection requests, as lenient as rcssserver and with its errors.
#include "soccer/commands/connection_request.h"

#include "soccer/protocol/loose_scanner.h"
#include "soccer/protocol/text_writer.h"

namespace cls::soccer {
namespace {

constexpr std::size_t kMaxLongNameSize = 127;  // coach names, team names of reconnect

// The pattern of rcssserver contains the range "+-_", reproduced here
// (docs/spec/server-protocol.md 1.2).
bool is_name_character(char c) { return (c >= '+' && c <= '_') || (c >= 'a' && c <= 'z'); }

bool is_command_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
         std::string_view("-.+*/?<>_").find(c) != std::string_view::npos;
}

std::string_view without_line_feed(std::string_view datagram) {
  return datagram.ends_with('\n') ? datagram.substr(0, datagram.size() - 1) : datagram;
}

bool at_parenthesis(const LooseScanner& in) { return in.peek() == '(' || in.peek() == ')'; }

// "(version V)" and white space after it.
bool read_version(LooseScanner& in, double& version) {
  if (!(in.token("(") && in.token("version") && in.number(version) && in.token(")"))) return false;
  in.skip_space();
  return true;
}

std::optional<ErrorCode> parse_player_init(LooseScanner& in, PlayerInit& out) {
  const std::string_view team = in.run(is_name_character, TeamName::kMaxSize);
  if (team.empty()) return ErrorCode::kIllegalTeamName;
  out.team = TeamName(team);

  in.skip_space();
  if (!at_parenthesis(in)) return ErrorCode::kIllegalTeamNameOrTooLong;
  in.skip_to('(');

  while (!in.at_end() && in.peek() != ')') {
    if (in.looking_at("(version ")) {
      if (!read_version(in, out.version)) return ErrorCode::kIllegalCommandForm;
    } else if (in.token("(goalie)")) {
      out.goalie = true;
      in.skip_space();
    } else {
      return ErrorCode::kIllegalCommandForm;
    }
    if (!at_parenthesis(in)) return ErrorCode::kIllegalCommandForm;
  }

  return std::nullopt;
}

std::optional<ErrorCode> parse_reconnect(LooseScanner& in, PlayerReconnect& out) {
  const auto not_space = [](char c) { return !LooseScanner::is_space(c); };
  out.team = in.run(not_space, kMaxLongNameSize);
  if (out.team.empty() || !in.integer(out.unum)) return ErrorCode::kIllegalCommandForm;
  return std::nullopt;
}

}  // namespace

std::optional<ErrorCode> parse(std::string_view datagram, GameRequest& out) {
  const std::string_view text = without_line_feed(datagram);
  LooseScanner in(text);

  if (text.starts_with("(dispinit)")) {
    out = MonitorInit{};
    return std::nullopt;
  }
  if (in.token("(") && in.token("dispinit") && in.token("version") &&
      in.number(out.emplace<MonitorInit>().version)) {
    return std::nullopt;
  }

  constexpr std::string_view kInit = "(init ";
  constexpr std::string_view kReconnect = "(reconnect ";
  if (text.starts_with(kInit)) {
    in = LooseScanner(text.substr(kInit.size()));
    return parse_player_init(in, out.emplace<PlayerInit>());
  }
  if (text.starts_with(kReconnect)) {
    in = LooseScanner(text.substr(kReconnect.size()));
    return parse_reconnect(in, out.emplace<PlayerReconnect>());
  }

  return ErrorCode::kUnknownCommand;
}

std::optional<ErrorCode> parse(std::string_view datagram, CoachInit& out) {
  out = CoachInit{};
  const std::string_view text = without_line_feed(datagram);
  LooseScanner in(text);

  if (!(text.starts_with("(init") && in.token("(init"))) return ErrorCode::kIllegalCommandForm;
  const std::string_view team = in.run(is_name_character, TeamName::kMaxSize);
  if (team.empty()) return ErrorCode::kIllegalCommandForm;

  out.team = TeamName(team);
  in.skip_space();

  if (in.peek() != '(') {
    out.coach_name = in.run(is_name_character, kMaxLongNameSize);
    if (out.coach_name.empty()) return ErrorCode::kIllegalCommandForm;
    in.skip_space();
    if (!at_parenthesis(in)) return ErrorCode::kIllegalCoachNameOrTooLong;
  }

  in.skip_to('(');
  if (!in.looking_at("(version")) return std::nullopt;
  if (!read_version(in, out.version)) return ErrorCode::kIllegalCommandForm;
  if (!at_parenthesis(in)) return ErrorCode::kIllegalClientVersion;

  return std::nullopt;
}

std::optional<ErrorCode> parse(std::string_view datagram, TrainerInit& out) {
  out = TrainerInit{};
  LooseScanner in(without_line_feed(datagram));
  if (!in.token("(") || in.run(is_command_character, kMaxLongNameSize) != "init" || in.at_end()) {
    return ErrorCode::kIllegalCommandForm;
  }

  if (in.token("(") && in.token("version")) in.number(out.version);
  if (out.version < 1.0) return ErrorCode::kIllegalCommandForm;
  return std::nullopt;
}

void format(const PlayerInit& request, std::string& out) {
  append(out, "(init ", request.team.view(), " (version ", request.version,
         request.goalie ? ") (goalie))" : "))");
}

void format(const PlayerReconnect& request, std::string& out) {
  append(out, "(reconnect ", request.team, ' ', request.unum, ')');
}

void format(const MonitorInit& request, std::string& out) {
  if (request.version == 1.0) {
    out.append("(dispinit)");
  } else {
    append(out, "(dispinit version ", request.version, ')');
  }
}

void format(const CoachInit& request, std::string& out) {
  append(out, "(init ", request.team.view());
  if (!request.coach_name.empty()) append(out, ' ', request.coach_name);
  append(out, " (version ", request.version, "))");
}

void format(const TrainerInit& request, std::string& out) {
  append(out, "(init (version ", request.version, "))");
}

}  // namespace cls::soccer
