// What players tell each other: the ten-character messages that helios teams understand.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "proxy/world/fixed_list.h"
#include "soccer/geometry.h"
#include "soccer/parameters/server_params.h"

namespace cls::proxy {

// Places and angles are in the speaker's frame: his team attacks +x. `number` is 1 to 11 for a
// player of the speaker's team and 12 to 22 for the opponent with that number less 11. What is
// written is rounded to the grid of the message (in brackets) and cut to its range.

struct SaidPlayer {
  int number = 0;
  soccer::Vec2 position;
};

/// 'b' + 5 characters: place (0.1 m), velocity (0.1 m per cycle), both of the next cycle.
struct SayBall {
  soccer::Vec2 position;
  soccer::Vec2 velocity;
};
/// 'p' + 9: to whom, where he is to receive it (0.1 m), and the ball.
struct SayPass {
  int receiver = 0;
  soccer::Vec2 point;
  SayBall ball;
};
/// 'i' + 2
struct SayIntercept {
  int number = 0;
  int cycles = 0;
};
/// 'g' + 4: the opponents' goalie near his goal (0.1 m, 1 degree).
struct SayGoalie {
  soccer::Vec2 position;
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
  soccer::Vec2 point;
};
/// 's', 'r', 'c' + 1: what is left, as a fraction (of the way from its least to its full value).
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
  soccer::Vec2 target;
  int count = 0;
};
/// 'G' + 9
struct SayBallGoalie {
  SayBall ball;
  SayGoalie goalie;
};
/// 'P', 'Q', 'R' + 3, 6, 9: one to three players (0.63 m).
struct SayPlayers {
  FixedList<SaidPlayer, 3> players;
};
/// 'S' + 4 (0.4 m, 6 degrees, stamina as a fraction in tenths)
struct SaySelf {
  soccer::Vec2 position;
  double body = 0.0;
  double stamina_fraction = 0.0;
};
/// 'T' and 'O' + 4 (0.7 m, 2 degrees); numbers 1 to 11 of the speaker's or the other team.
struct SayTeammate {
  int unum = 0;
  soccer::Vec2 position;
  double body = 0.0;
};
struct SayOpponent {
  int unum = 0;
  soccer::Vec2 position;
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

/// Takes the first message off the front of `text` (a say may hold several). Nothing, leaving
/// `text` as it is, for an unknown header, too few characters, or a number nobody has.
std::optional<SayMessage> take_say_message(std::string_view& text,
                                           const soccer::ServerParams& server);

/// Appends the message. False, appending nothing, for what it cannot say: a number out of range, a
/// goalie away from his goal (x 37 to 52.9 and |y| up to 19.9; in SayBallGoalie x from 36.5), an
/// offside line below 10, a defence line above -10, no or more than three players.
[[nodiscard]] bool append_say_message(const SayMessage& message, const soccer::ServerParams& server,
                                      std::string& out);

}  // namespace cls::proxy
