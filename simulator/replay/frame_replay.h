// Replay of single frames: worlds from frames, recorded outcomes, deviations from the record.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gamelog/record/frame.h"
#include "simulator/world/event.h"

namespace cls::simulator {

/// Sets players and ball from the frame. State that frames do not contain stays unchanged: clock,
/// mode, referee state, blocked and banned players, and stamina capacity in rcg versions before 5.
void restore(World& world, const gamelog::Frame& frame);

/// A world at the first frame of a recorded match, one step after its kick-off.
World world_at_kick_off(std::shared_ptr<const Rules> rules, const gamelog::Frame& frame);

/// Outcomes of tackles and catches in the frame after the step.
ReplayOverrides recorded_outcomes(const gamelog::Frame& after);

/// Adds the recorded arrivals of ball and players, for matches with noise. For objects that
/// collided or were moved, the arrival follows from the recorded velocity. `world` is the world
/// before the step, with its commands applied.
void override_arrivals(ReplayOverrides& overrides, const World& world, const gamelog::Frame& after);

/// Adds the fouls called in the step: foul_charge_l, yellow_card_r_7, red_card_l_3. Other tackles
/// of the step were not fouls. `called_after` has the sender of the last command before each call,
/// because the server calls fouls immediately. If that is not a tackler of the side, all its
/// tackles were fouls.
void override_fouls(ReplayOverrides& overrides, const std::vector<std::string>& calls,
                    const std::vector<Slot>& called_after);

/// Adds goal and first taker of a shoot-out from the calls penalty_onfield_l and penalty_setup_r.
void override_shoot_out(ReplayOverrides& overrides, const std::vector<std::string>& calls);

/// Largest differences between a simulated and a recorded object, in meters, meters per cycle and
/// degrees.
struct Deviation {
  double position = 0.0;
  double velocity = 0.0;
  double body = 0.0;
  double neck = 0.0;
  double stamina = 0.0;
  double effort = 0.0;  ///< or recovery
  double capacity = 0.0;
  bool same_counters = true;
};

Deviation ball_deviation(const World& world, const gamelog::Frame& frame);
Deviation player_deviation(const World& world, const gamelog::Frame& frame, Slot slot);

}  // namespace cls::simulator
