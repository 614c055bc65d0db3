// Recursive descent parser of the player command grammar of rcssserver.
#include "soccer/commands/player_command.h"

#include <array>

#include "soccer/commands/player_command_lexer.h"

namespace cls::soccer {
namespace {

using Kind = CommandToken::Kind;

// One token of lookahead. Functions named after a part of the grammar consume it and return true,
// or return false at the first token that does not match.
class CommandParser {
 public:
  CommandParser(std::string_view datagram, std::vector<PlayerCommand>& out)
      : lexer_(datagram), out_(out) {
    advance();
  }

  std::optional<std::size_t> parse() {
    do {
      if (!command()) return token_.position;
    } while (token_.kind != Kind::kEnd);
    return std::nullopt;
  }

 private:
  struct Entry {
    std::string_view name;
    bool (CommandParser::*arguments)();
  };

  void advance() { token_ = lexer_.next(); }
  bool at_keyword(std::string_view keyword) const {
    return token_.kind == Kind::kName && token_.text == keyword;
  }
  bool accept_keyword(std::string_view keyword) {
    if (!at_keyword(keyword)) return false;
    advance();
    return true;
  }
  bool accept(Kind kind) {
    if (token_.kind != kind) return false;
    advance();
    return true;
  }
  bool open() { return accept(Kind::kOpen); }
  bool close() { return accept(Kind::kClose); }

  bool number(double& value) {
    if (token_.kind != Kind::kInteger && token_.kind != Kind::kReal) return false;
    value = token_.number;
    advance();
    return true;
  }
  bool integer(int& value) {
    if (token_.kind != Kind::kInteger) return false;
    value = token_.integer;
    advance();
    return true;
  }

  // The closing parenthesis completes a command.
  template <typename Command>
  bool finish(Command command) {
    if (!close()) return false;
    out_.emplace_back(std::move(command));
    return true;
  }

  template <typename Command>
  bool plain() {
    return finish(Command{});
  }
  template <typename Command>
  bool one_number() {
    double value = 0.0;
    return number(value) && finish(Command{value});
  }
  template <typename Command>
  bool two_numbers() {
    double first = 0.0;
    double second = 0.0;
    return number(first) && number(second) && finish(Command{first, second});
  }

  bool command();
  bool dash();
  bool dash_leg(LegDash& legs);
  bool leg_dash();
  bool say();
  bool change_view();
  bool point_to();
  bool attention_to();
  bool tackle();
  bool clang();
  bool ear();
  bool compression();
  bool team(std::optional<TeamReference>& team);
  bool boolean(bool& value);

  static const std::array<Entry, 22> kEntries;

  CommandLexer lexer_;
  CommandToken token_;
  std::vector<PlayerCommand>& out_;
};

const std::array<CommandParser::Entry, 22> CommandParser::kEntries = {{
    {"turn", &CommandParser::one_number<Turn>},
    {"dash", &CommandParser::dash},
    {"turn_neck", &CommandParser::one_number<TurnNeck>},
    {"change_view", &CommandParser::change_view},
    {"change_focus", &CommandParser::two_numbers<ChangeFocus>},
    {"kick", &CommandParser::two_numbers<Kick>},
    {"done", &CommandParser::plain<Done>},
    {"say", &CommandParser::say},
    {"attentionto", &CommandParser::attention_to},
    {"pointto", &CommandParser::point_to},
    {"tackle", &CommandParser::tackle},
    {"catch", &CommandParser::one_number<Catch>},
    {"move", &CommandParser::two_numbers<Move>},
    {"long_kick", &CommandParser::two_numbers<LongKick>},
    {"sense_body", &CommandParser::plain<RequestSenseBody>},
    {"score", &CommandParser::plain<RequestScore>},
    {"bye", &CommandParser::plain<Bye>},
    {"synch_see", &CommandParser::plain<SynchSee>},
    {"gaussian_see", &CommandParser::plain<GaussianSee>},
    {"clang", &CommandParser::clang},
    {"ear", &CommandParser::ear},
    {"compression", &CommandParser::compression},
}};

bool CommandParser::command() {
  if (token_.kind == Kind::kUnquotedSay) {
    out_.emplace_back(Say{std::string(token_.text)});
    advance();
    return true;
  }

  if (!open()) return false;
  for (const Entry& entry : kEntries) {
    if (accept_keyword(entry.name)) return (this->*entry.arguments)();
  }

  return false;
}

bool CommandParser::dash() {
  if (token_.kind == Kind::kOpen) return leg_dash();

  Dash dash;
  if (!number(dash.power)) return false;
  if (token_.kind != Kind::kClose && !number(dash.direction)) return false;

  return finish(dash);
}

// "(l P D)" for a leg that is not set yet.
bool CommandParser::dash_leg(LegDash& legs) {
  if (!open()) return false;

  const bool left = at_keyword("l") || at_keyword("left");
  if (!left && !at_keyword("r") && !at_keyword("right")) return false;
  std::optional<Dash>& leg = left ? legs.left : legs.right;
  if (leg) return false;

  advance();
  Dash dash;
  if (!(number(dash.power) && number(dash.direction) && close())) return false;
  leg = dash;

  return true;
}

// rcssserver executes each leg at its closing parenthesis, so legs before an error remain.
bool CommandParser::leg_dash() {
  LegDash legs;
  const bool complete = dash_leg(legs) && (token_.kind != Kind::kOpen || dash_leg(legs)) && close();
  if (legs.left || legs.right) out_.emplace_back(legs);
  return complete;
}

bool CommandParser::say() {
  const bool quoted = token_.kind == Kind::kQuoted;
  if (!quoted && (token_.kind != Kind::kName || is_command_keyword(token_.text))) return false;

  const std::string_view text = token_.text;
  advance();
  return finish(Say{std::string(quoted ? text.substr(1, text.size() - 2) : text)});
}

bool CommandParser::change_view() {
  if (token_.kind != Kind::kName) return false;

  ChangeView view;
  const std::optional<ViewWidth> width = kViewWidths.parse(token_.text);
  if (!width) return false;

  view.width = *width;
  advance();
  if (token_.kind == Kind::kName) {
    view.quality = kViewQualities.parse(token_.text);
    if (!view.quality) return false;
    advance();
  }

  return finish(view);
}

bool CommandParser::point_to() {
  if (accept_keyword("off")) return plain<PointToOff>();
  return two_numbers<PointTo>();
}

// Leaves `team` empty if the next token is not a team.
bool CommandParser::team(std::optional<TeamReference>& team) {
  using Team = TeamReference::Kind;
  struct Name {
    std::string_view text;
    Team kind;
  };
  constexpr std::array<Name, 6> kNames = {{{"our", Team::kOur},
                                           {"opp", Team::kOpponent},
                                           {"l", Team::kLeft},
                                           {"left", Team::kLeft},
                                           {"r", Team::kRight},
                                           {"right", Team::kRight}}};

  for (const Name& name : kNames) {
    if (!accept_keyword(name.text)) continue;
    team = TeamReference{name.kind, {}};
    return true;
  }

  const bool named = token_.kind == Kind::kQuoted ||
                     (token_.kind == Kind::kName && !is_command_keyword(token_.text));
  if (!named) return false;

  team = TeamReference{Team::kNamed, std::string(token_.text)};
  advance();
  return true;
}

bool CommandParser::attention_to() {
  if (accept_keyword("off")) return plain<AttentionToOff>();

  std::optional<TeamReference> reference;
  int unum = 0;
  return team(reference) && integer(unum) && finish(AttentionTo{std::move(*reference), unum});
}

bool CommandParser::boolean(bool& value) {
  value = at_keyword("on") || at_keyword("true");
  if (!value && !at_keyword("off") && !at_keyword("false")) return false;

  advance();
  return true;
}

bool CommandParser::tackle() {
  Tackle tackle;
  if (!number(tackle.angle_or_power)) return false;
  if (token_.kind != Kind::kClose && !boolean(tackle.foul)) return false;
  return finish(tackle);
}

bool CommandParser::clang() {
  Clang clang;
  return open() && accept_keyword("ver") && integer(clang.min_version) &&
         integer(clang.max_version) && close() && finish(clang);
}

bool CommandParser::ear() {
  Ear ear;
  if (!open()) return false;

  ear.on = accept_keyword("on");
  if (!ear.on && !accept_keyword("off")) return false;

  team(ear.team);
  if (accept_keyword("partial") || accept_keyword("p")) {
    ear.mode = EarMode::kPartial;
  } else if (accept_keyword("complete") || accept_keyword("c")) {
    ear.mode = EarMode::kComplete;
  }

  return close() && finish(std::move(ear));
}

bool CommandParser::compression() {
  Compression compression;
  return integer(compression.level) && finish(compression);
}

}  // namespace

std::optional<std::size_t> parse_player_commands(std::string_view datagram,
                                                 std::vector<PlayerCommand>& out) {
  return CommandParser(datagram, out).parse();
}

}  // namespace cls::soccer
