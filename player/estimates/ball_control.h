// Who can play the ball now: kickable flags, catch, tackle and foul probabilities, last kicker.
#pragma once

#include "player/world/world_model.h"

namespace cls::player {

/// Sets kickable, kick_rate, the catch, tackle and foul probabilities and the safe dash power of
/// `world.self` (docs/spec/proxy-behavior.md 3.4). Foul probabilities assume that an opponent has
/// the ball.
void update_action_probabilities(WorldModel& world);

/// Maximum catch distance of a goalie, and the distance within which a catch is reliable.
struct CatchReach {
  double sure = 0.0;
  double farthest = 0.0;
};
CatchReach catch_reach(const WorldModel& world);

/// Sets kickable_teammate_id and kickable_opponent_id (docs/spec/proxy-behavior.md 3.7).
void update_kickable_players(WorldModel& world);

/// Updates last_kick from own kicks, kick marks in see messages, and jumps of the ball velocity
/// while only one team could kick. Uses the kickable players of the previous decision: call it
/// before update_kickable_players().
void update_last_kicker(WorldModel& world);

}  // namespace cls::player
