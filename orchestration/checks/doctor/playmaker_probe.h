// `cls doctor --playmaker`: does this Playmaker answer, and can it decide?
#pragma once

#include <atomic>
#include <chrono>

#include "orchestration/checks/doctor/diagnosis.h"
#include "orchestration/match/options/endpoint.h"

namespace cls::orchestration::checks {

/// Connects, takes two players through the handshake, asks for one decision and for one of the
/// planner: the first steps of `cls check playmaker`. No agent says good-bye, because some
/// Playmakers end when nobody is left. The first thing that fails ends it; `limit` holds for each
/// answer.
Symptom probe_playmaker(const match::Endpoint& endpoint, std::chrono::milliseconds limit,
                        const std::atomic<int>& stop);

}  // namespace cls::orchestration::checks
