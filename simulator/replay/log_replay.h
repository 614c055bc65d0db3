// Replays a match from its game log and text log, step by step.
#pragma once

#include "base/result.h"
#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/match_record.h"
#include "simulator/replay/log_agreement.h"

namespace cls::simulator {

/// Simulates each step from the recorded frame and the commands of the text log, and compares it
/// with the next frame. Clock, mode, score and referee state are simulated; after a difference they
/// continue as recorded. Random outcomes and noise are taken from the record where noise can
/// explain it. Errors: too little precision (rcg versions 1 to 3), logs of different matches,
/// invalid parameters.
base::Result<LogAgreement> replay_log(const gamelog::MatchRecord& game,
                                      const gamelog::RclRecord& text);

}  // namespace cls::simulator
