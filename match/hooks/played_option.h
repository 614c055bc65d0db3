// Which option of the action set "options" a decision of a player amounts to.
#pragma once

#include <string>

#include "player/options/options.h"
#include "proxy/agent/decision_listener.h"

namespace cls::match {

/// What a player did with the ball.
struct PlayedOption {
  int id = -1;         ///< of a legal option; -1: none is like it
  std::string action;  ///< as members of PlayerAction are named, or "policy"; empty: none
};

/// Of an executed decision. `table`: what the player could choose, with the ball. Kicks count as
/// the dribble or pass that leads to their target (player/options/played_options.h), turns as
/// holding the ball; other moves of a player with the ball are like no option.
PlayedOption played_option(const proxy::Decision& decision, const player::OptionTable& table);

}  // namespace cls::match
