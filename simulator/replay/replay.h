// Stepping a recorded match again: is what we reckon what the real server recorded?
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gamelog/record/frame.h"
#include "simulator/world/event.h"

namespace cls::simulator {

/// Sets players and ball to what the frame shows. What a frame does not show stays: clock, mode,
/// the referee's memory, blocked and banned players, the capacity in logs of before version 5. A
/// rounded frame gives a rounded world.
void restore(World& world, const gamelog::Frame& frame);

/// A world at the first frame of a recorded match, one step after its kick-off.
World world_at_kick_off(std::shared_ptr<const Rules> rules, const gamelog::Frame& frame);

/// Tackles and catches whose outcome the frame after the step shows.
ForcedOutcomes shown_outcomes(const gamelog::Frame& after);

/// Adds where the frame shows ball and players, and how players turned: for matches with noise.
/// Of what collided or was put elsewhere the frame's velocity tells where the step took it first;
/// `world` is that before the step, with its commands.
void force_arrivals(ForcedOutcomes& outcomes, const World& world, const gamelog::Frame& after);

/// Adds what the referee said of fouls in the step: foul_charge_l, yellow_card_r_7, red_card_l_3.
/// All other tackles of the step were none. `called_after` names, for each word, whose command was
/// received last before it: the server calls a foul at once. Where that is no tackler of the side,
/// every tackle of the side was one.
void force_fouls(ForcedOutcomes& outcomes, const std::vector<std::string>& referee_words,
                 const std::vector<Slot>& called_after);

/// Adds what the referee said of a shoot-out's start: penalty_onfield_l, penalty_setup_r.
void force_shoot_out(ForcedOutcomes& outcomes, const std::vector<std::string>& referee_words);

/// Largest differences between a player or ball as reckoned and as recorded. Metres, metres per
/// cycle, degrees.
struct Deviation {
  double position = 0.0;
  double velocity = 0.0;
  double body = 0.0;
  double neck = 0.0;
  double stamina = 0.0;
  double effort = 0.0;  ///< and recovery
  double capacity = 0.0;
  bool same_counters = true;
  bool same_state = true;
};

Deviation ball_deviation(const World& world, const gamelog::Frame& frame);
Deviation player_deviation(const World& world, const gamelog::Frame& frame, Slot slot);

}  // namespace cls::simulator
