// What a player says to the server: one plain struct per command, parsed and formatted.
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

// Angles are in degrees, relative as the command has it (body for turn, kick, dash, catch and
// tackle; body plus neck for pointto and change_focus); powers are unclipped: a parsed command
// holds what the client wrote. Source: rcssserver 19 player command grammar (protocol 3).

struct Turn {
  double moment = 0.0;
};

/// Both legs with the same power and direction.
struct Dash {
  double power = 0.0;
  double direction = 0.0;
};

/// One or both legs with their own power and direction; at least one leg is present.
struct LegDash {
  std::optional<Dash> left;
  std::optional<Dash> right;
};

struct TurnNeck {
  double moment = 0.0;
};

/// Moves the focus point: a change of its distance (metres) and of its direction.
struct ChangeFocus {
  double moment_distance = 0.0;
  double moment_direction = 0.0;
};

struct Kick {
  double power = 0.0;
  double direction = 0.0;
};

/// Part of the grammar without an effect in the game.
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

/// In the player's own frame: the right team's coordinates are mirrored by the server.
struct Move {
  double x = 0.0;
  double y = 0.0;
};

/// Without a quality the server takes high.
struct ChangeView {
  ViewWidth width = ViewWidth::kNormal;
  std::optional<ViewQuality> quality;
};

struct SynchSee {};
struct GaussianSee {};

/// Text without quotes: one or more of 0-9 A-Z a-z blank ( ) . + * / ? < > _ -
struct Say {
  std::string text;
};

struct PointTo {
  double distance = 0.0;
  double direction = 0.0;
};
struct PointToOff {};

/// A team as attentionto and ear name it. `name` is used with kNamed only and is the word as
/// written (quotes included if the client quoted it).
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

/// The coach language versions the player understands.
struct Clang {
  int min_version = 0;
  int max_version = 0;
};

struct AskSenseBody {};
struct AskScore {};
struct Done {};
struct Bye {};
struct Compression {
  int level = 0;
};

using PlayerCommand =
    std::variant<Turn, Dash, LegDash, TurnNeck, ChangeFocus, Kick, LongKick, Catch, Tackle, Move,
                 ChangeView, SynchSee, GaussianSee, Say, PointTo, PointToOff, AttentionTo,
                 AttentionToOff, Ear, Clang, AskSenseBody, AskScore, Done, Bye, Compression>;

/// Reads a datagram, a list of one or more commands, and appends them to `out` (its capacity is
/// reused). The result is nothing when all of it was read, else the byte offset of the syntax
/// error: the commands before it stand, as the real server has executed them by then, the rest
/// is dropped and `(error illegal_command_form)` is due. An empty or blank datagram is such an
/// error. A leg of a dash counts as a command of its own here: an error behind it keeps it.
std::optional<std::size_t> parse_player_commands(std::string_view datagram,
                                                 std::vector<PlayerCommand>& out);

/// Appends the command as the grammar wants it; numbers in the shortest form that reads back
/// exactly, say texts in quotes. False, appending nothing, for a command the grammar cannot say:
/// a number that is not finite, a say text that is empty or has other characters, a team word of
/// other characters than [-_a-zA-Z0-9] or that is a keyword or number, a LegDash without legs.
[[nodiscard]] bool format(const PlayerCommand& command, std::string& out);

/// True if every character may be said and there is at least one. Length is the server's matter
/// (`say_msg_size`).
bool is_sayable(std::string_view text);

}  // namespace cls::soccer
