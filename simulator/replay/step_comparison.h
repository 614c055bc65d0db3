// Comparing one reckoned step with the recorded frame.
#pragma once

#include "gamelog/record/frame.h"
#include "simulator/replay/log_agreement.h"
#include "simulator/replay/recorded_step.h"

namespace cls::simulator {

struct ReckonedStep {
  const World& before;  ///< ahead of the commands, as recorded
  const World& after;   ///< its `forced` tells what was drawn
  const gamelog::Frame& recorded;
  Clock clock;  ///< of the recorded frame
  bool half_time = false;
  bool push_cut_off = false;  ///< a limit may have cut what a kick gave the ball
  OpenOutcomes open;          ///< what noise decided
};

void compare_step(const ReckonedStep& step, LogAgreement& result);

}  // namespace cls::simulator
