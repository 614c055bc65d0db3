// The side at fault when a match ends early.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "match/result/match_end.h"
#include "match/result/match_result.h"
#include "match/result/speed.h"
#include "match/sides/match_side.h"
#include "soccer/per_side.h"

namespace cls::match {

/// The sides whose Playmaker has kept the match waiting for longer than `limit`.
std::vector<const MatchSide*> sides_awaited_for(const Sides& sides,
                                                std::chrono::duration<double> limit);

/// Adds to `end` that `side` is at fault: its process or Playmaker, and the RPC that it has not
/// answered.
void blame(const MatchSide& side, const MatchMoment& moment, MatchEnd& end);

/// Adds to `end`, of a server whose clients stopped responding, whose they were if that is certain:
/// agents of cls reply to every cycle unless their Playmaker is awaited, and the embedded server
/// reports how long it has waited for each side (`awaited_s`).
void blame_unresponsive(const Sides& sides, const std::optional<soccer::PerSide<double>>& awaited_s,
                        MatchEnd& end);

/// The share of a match's time that a side, and not the server or the clock, took.
double share_of(const SpeedResult& speed, soccer::Side side);
/// The side that took more than half of the time: without it the match would have been in time.
std::optional<soccer::Side> side_of_most_time(const std::optional<SpeedResult>& speed);

/// What the programs of a side took of the processors of this host.
struct ProcessorTime {
  double used_s = 0.0;
  double delayed_s = 0.0;  ///< ready to run, without a processor
};
/// Of the programs that cls started for `side`.
ProcessorTime processor_time(const std::vector<ProcessResult>& processes, soccer::Side side);

/// True if a side that took most of a match's time did so because its opponent took the processors:
/// it waited for one for longer than it had one, and the opponent used more than twice as much.
bool was_starved(const ProcessorTime& own, const ProcessorTime& opponent);

/// "brain (localhost:50051): no reply to GetPlayerActions of player 7 at cycle 12; ...: STALL".
std::string stall_message(const std::vector<const MatchSide*>& sides, int cycle,
                          const std::string& stall);

}  // namespace cls::match
