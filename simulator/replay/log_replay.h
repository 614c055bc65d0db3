// Replaying a match from its two logs, one step at a time.
#pragma once

#include "base/result.h"
#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/match_record.h"
#include "simulator/replay/log_agreement.h"

namespace cls::simulator {

/// Each step starts from the recorded frame with the commands of the text log and is compared with
/// the next frame; clock, mode, score and the referee's memory are ours throughout, until they
/// differ: then they go on as recorded. Outcomes of draws are taken from the record, and so is
/// noise, as far as noise can do it. The error says why the logs cannot be replayed: too few digits
/// (versions 1 to 3), logs of different matches, parameters that make no match.
base::Result<LogAgreement> replay_log(const gamelog::MatchRecord& game,
                                      const gamelog::RclRecord& text);

}  // namespace cls::simulator
