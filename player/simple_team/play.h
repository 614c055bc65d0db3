// The parts of the simple team's play: each appends the actions of one player for one cycle.
#pragma once

#include "player/simple_team/action_list.h"
#include "player/simple_team/situation.h"
#include "soccer/geometry.h"

namespace cls::player {

/// Shoots, passes, dribbles or clears; the player can kick the ball now.
void attack(const Situation& now, ActionList& list);

/// Takes a set play: the best pass, otherwise a long ball.
void kick_set_play(const Situation& now, ActionList& list);

/// A field player without the ball: intercepts when no teammate is faster, tackles, blocks, or
/// returns to the formation.
void play_without_ball(const Situation& now, ActionList& list);

/// Moves to the home position for the current ball.
void go_home(const Situation& now, ActionList& list);

/// The goalie: catches, intercepts, clears, or narrows the angle.
void keep_goal(const Situation& now, ActionList& list);

/// The goalie with the caught ball.
void bring_out_caught_ball(const Situation& now, ActionList& list);

/// Set plays: the nearest player takes the team's own set play; all other players move to their
/// home positions.
void play_set_play(const Situation& now, ActionList& list);

/// Home position for the current ball; never offside. The team attacks +x.
Vec2 home_position(const Situation& now);

/// Position in the own half before a kick-off.
Vec2 kick_off_position(const Situation& now);

}  // namespace cls::player
