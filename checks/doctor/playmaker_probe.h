// `cls doctor --playmaker`: whether a Playmaker responds and decides.
#pragma once

#include <atomic>
#include <chrono>

#include "checks/doctor/doctor_report.h"
#include "match/terms/endpoint.h"

namespace cls::checks {

/// Connects, completes the handshake of two players, requests one decision and one planner
/// decision: the first steps of `cls check playmaker`. Sends no bye, because some Playmakers exit
/// after the last agent has left. Stops at the first failure; `limit` is the deadline of each
/// reply.
DoctorCheck probe_playmaker(const match::Endpoint& endpoint, std::chrono::milliseconds limit,
                            const std::atomic<int>& stop);

}  // namespace cls::checks
