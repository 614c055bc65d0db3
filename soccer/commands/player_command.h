// Player commands: one struct per command.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "soccer/protocol/view_mode.h"

namespace cls::soccer {

// Angles are in degrees relative to the body (turn, kick, dash, catch, tackle) or to body plus neck
// (pointto, change_focus). Parsed commands hold the values of the client, unclipped. Source:
// rcssserver 19 player command grammar (docs/spec/server-protocol.md 3).

struct Turn {
  double moment = 0.0;
};

/// Dashes with both legs, with the same power and direction.
struct Dash {
  double power = 0.0;
  double direction = 0.0;
};

/// One or both legs, each with power and direction; at least one leg is present.
struct LegDash {
  std::optional<Dash> left;
  std::optional<Dash> right;
};

struct TurnNeck {
  double moment = 0.0;
};

/// Changes distance (meters) and direction of the focus point.
struct ChangeFocus {
  double moment_distance = 0.0;
  double moment_direction = 0.0;
};

struct Kick {
  double power = 0.0;
  double direction = 0.0;
};

/// Part of the grammar, without effect.
struct LongKick {
  double power = 0.0;
  double direction = 0.0;
};

struct Catch {
  double direction = 0.0;
};

/// `angle_or_power` is an angle for clients of version 12 and later, a power for older ones.
struct Tackle {
  double angle_or_power = 0.0;
  bool foul = false;
};

/// In the frame of the own team: the server mirrors the coordinates of the right team.
struct Move {
  double x = 0.0;
  double y = 0.0;
};

/// Without a quality the server uses high.
struct ChangeView {
  ViewWidth width = ViewWidth::kNormal;
  std::optional<ViewQuality> quality;
};

struct SynchSee {};
struct GaussianSee {};

/// Text without quotes: one or more of 0-9 A-Z a-z space ( ) . + * / ? < > _ -
struct Say {
  std::string text;
};

struct PointTo {
  double distance = 0.0;
  double direction = 0.0;
};
struct PointToOff {};

/// A team in attentionto and ear. `name` is for kNamed only: the token as sent, with quotes if the
/// client quoted it.
struct TeamReference {
  enum class Kind : std::uint8_t { kOur, kOpponent, kLeft, kRight, kNamed };
  Kind kind = Kind::kOur;
  std::string name;
};

struct AttentionTo {
  TeamReference team;
  int unum = 0;
};
struct AttentionToOff {};

enum class EarMode : std::uint8_t { kPartial, kComplete };

/// No team means both sides, no mode both modes.
struct Ear {
  bool on = true;
  std::optional<TeamReference> team;
  std::optional<EarMode> mode;
};

/// The coach language versions that the player supports.
struct Clang {
  int min_version = 0;
  int max_version = 0;
};

struct RequestSenseBody {};
struct RequestScore {};
struct Done {};
struct Bye {};
struct Compression {
  int level = 0;
};

using PlayerCommand = std::variant<Turn, Dash, LegDash, TurnNeck, ChangeFocus, Kick, LongKick,
                                   Catch, Tackle, Move, ChangeView, SynchSee, GaussianSee, Say,
                                   PointTo, PointToOff, AttentionTo, AttentionToOff, Ear, Clang,
                                   RequestSenseBody, RequestScore, Done, Bye, Compression>;

/// Parses a datagram of one or more commands and appends them to `out`, reusing its capacity.
/// Returns the byte offset of a syntax error, or nothing. After an error the commands before it
/// remain, because rcssserver has executed them by then, and the server replies
/// `(error illegal_command_form)`. An empty datagram is an error. A leg of a dash counts as a
/// command: it remains if an error follows.
std::optional<std::size_t> parse_player_commands(std::string_view datagram,
                                                 std::vector<PlayerCommand>& out);

/// Appends the command, with numbers in the shortest form that parses to the same value and say
/// texts in quotes. False, appending nothing, for commands that the grammar cannot express: numbers
/// that are not finite, say texts that are empty or have other characters, team names with
/// characters other than [-_a-zA-Z0-9] or equal to a keyword or number, a LegDash without legs.
[[nodiscard]] bool format(const PlayerCommand& command, std::string& out);

/// True for one or more say characters. The server checks the length (`say_msg_size`).
bool is_sayable(std::string_view text);

}  // namespace cls::soccer
