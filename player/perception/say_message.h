// Say messages of players: the ten-character format of helios teams.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "base/fixed_list.h"
#include "player/world/vocabulary.h"
#include "soccer/parameters/server_params.h"

namespace cls::player {

// Positions and angles are in the speaker's frame: its team attacks +x. `number` is 1 to 11 for a
// teammate of the speaker and 12 to 22 for opponents 1 to 11. Values are rounded to the grid of the
// message (in parentheses) and clamped to its range.

struct SaidPlayer {
  int number = 0;
  Vec2 position;
};

/// 'b' + 5 characters: position (0.1 m) and velocity (0.1 m per cycle) in the next cycle.
struct SayBall {
  Vec2 position;
  Vec2 velocity;
};
/// 'p' + 9: receiver, receive point (0.1 m), and the ball.
struct SayPass {
  int receiver = 0;
  Vec2 point;
  SayBall ball;
};
/// 'i' + 2
struct SayIntercept {
  int number = 0;
  int cycles = 0;
};
/// 'g' + 4: the opponents' goalie near its goal (0.1 m, 1 degree).
struct SayGoalie {
  Vec2 position;
  double body = 0.0;
};
/// 'e' + 7 (player: 0.555 m)
struct SayGoalieAndPlayer {
  SayGoalie goalie;
  SaidPlayer player;
};
/// 'o' + 1: 10 to 52 (0.6 m)
struct SayOffsideLine {
  double x = 0.0;
};
/// 'd' + 1: -52 to -10 (0.6 m)
struct SayDefenseLine {
  double x = 0.0;
};
/// 'w'
struct SayWaitRequest {};
/// 'F' + 1
struct SaySetplay {
  int wait_cycles = 0;
};
/// 'h' + 3 (0.2 m)
struct SayPassRequest {
  Vec2 point;
};
/// 's', 'r', 'c' + 1: remaining stamina, recovery, capacity as a fraction of the range from minimum
/// to maximum.
struct SayStamina {
  double fraction = 0.0;
};
struct SayRecovery {
  double fraction = 0.0;
};
struct SayCapacity {
  double fraction = 0.0;
};
/// 'D' + 3 (0.5 m)
struct SayDribble {
  Vec2 target;
  int count = 0;
};
/// 'G' + 9
struct SayBallGoalie {
  SayBall ball;
  SayGoalie goalie;
};
/// 'P', 'Q', 'R' + 3, 6, 9: one to three players (0.63 m).
struct SayPlayers {
  base::FixedList<SaidPlayer, 3> players;
};
/// 'S' + 4 (0.4 m, 6 degrees, stamina as a fraction in tenths)
struct SaySelf {
  Vec2 position;
  double body = 0.0;
  double stamina_fraction = 0.0;
};
/// 'T' and 'O' + 4 (0.7 m, 2 degrees): teammate or opponent, numbers 1 to 11.
struct SayTeammate {
  int unum = 0;
  Vec2 position;
  double body = 0.0;
};
struct SayOpponent {
  int unum = 0;
  Vec2 position;
  double body = 0.0;
};
/// 'B' + 9 (player: 1 m, 2 degrees)
struct SayBallPlayer {
  SayBall ball;
  SaidPlayer player;
  double body = 0.0;
};

using SayMessage =
    std::variant<SayBall, SayPass, SayIntercept, SayGoalie, SayGoalieAndPlayer, SayOffsideLine,
                 SayDefenseLine, SayWaitRequest, SaySetplay, SayPassRequest, SayStamina,
                 SayRecovery, SayCapacity, SayDribble, SayBallGoalie, SayPlayers, SaySelf,
                 SayTeammate, SayOpponent, SayBallPlayer>;

/// Parses and removes the first message of `text` (a say may contain several). Empty, leaving
/// `text` unchanged, for an unknown header, too few characters or an invalid number.
std::optional<SayMessage> parse_say_message(std::string_view& text,
                                            const soccer::ServerParams& server);

/// Appends the formatted message. False without change for unsupported values: an invalid number, a
/// goalie away from its goal (outside x 37 to 52.9, |y| up to 19.9; in SayBallGoalie x from 36.5),
/// an offside line below 10, a defense line above -10, no or more than three players.
[[nodiscard]] bool append_say_message(const SayMessage& message, const soccer::ServerParams& server,
                                      std::string& out);

}  // namespace cls::player
