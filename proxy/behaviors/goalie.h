// The goalie's play.
#pragma once

#include "proxy/planner/action_context.h"

namespace cls::proxy {

/// Catches what can be caught, kicks out what is at its feet, else goalie_move().
bool play_goalie(ActionContext& context);

/// Goes for the ball when that is the goalie's business, else keeps the angle small.
bool goalie_move(ActionContext& context);

/// Kicks the ball out of danger: to a free teammate when there is a sure one, else away.
bool goalie_kick(ActionContext& context);

/// True for points of the own penalty area, at least `inset` metres inside.
bool in_own_penalty_area(soccer::Vec2 point, double inset = 0.0);

}  // namespace cls::proxy
