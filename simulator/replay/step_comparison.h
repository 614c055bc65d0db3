// Compares a simulated step with the recorded frame.
#pragma once

#include "gamelog/record/frame.h"
#include "simulator/replay/log_agreement.h"
#include "simulator/replay/recorded_step.h"

namespace cls::simulator {

struct SimulatedStep {
  const World& before;  ///< before the commands, as recorded
  const World& after;   ///< its overrides contain the drawn outcomes
  const gamelog::Frame& recorded;
  Clock clock;  ///< of the recorded frame
  bool half_time = false;
  bool push_cut_off = false;  ///< a speed or acceleration limit may have reduced a kick
  NoiseDecisions noise_decided;
};

void compare_step(const SimulatedStep& step, LogAgreement& result);

}  // namespace cls::simulator
