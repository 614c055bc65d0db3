// Plays in scripted matches, and what the analysis finds there.
#pragma once

#include <string_view>
#include <vector>

#include "analysis/play/carries.h"
#include "analysis/play/passes.h"
#include "analysis/play/shots.h"
#include "gamelog/rcl/rcl_reader.h"
#include "tests/gamelog/scripted_match.h"

namespace cls::analysis {

/// The play of a match, which must outlive it.
struct Play {
  explicit Play(const tests::ScriptedMatch& match) : flow(build_flow(match.record())) {}

  Flow flow;
  std::vector<Shot> shots = find_shots(flow);
  std::vector<Pass> passes = find_passes(flow, shots);
  std::vector<Carry> carries = find_carries(flow);
  std::vector<Goal> goals = find_goals(flow, shots);
};

inline gamelog::RclRecord text_log(std::string_view log) {
  base::MemorySource source(log);
  return gamelog::read_rcl(source);
}

/// Appends a frame in which the ball lies at `from`, then one in which the player has kicked it.
inline void kick_from(tests::ScriptedMatch& match, soccer::Vec2 from, int slot,
                      soccer::Vec2 launch) {
  match.place_ball(from);
  match.step();
  match.kick(slot, launch);
}

/// In the next frame the player has caught the ball.
inline void catch_ball(tests::ScriptedMatch& match, int slot) {
  ++match.player(slot).counts.catches;
  match.player(slot).state |= gamelog::kStateCatch;
}

/// In the next frame the player has tackled without reaching the ball.
inline void miss_ball(tests::ScriptedMatch& match, int slot) {
  ++match.player(slot).counts.tackle;
  match.player(slot).state |= gamelog::kStateTackle | gamelog::kStateTackleFailed;
}

/// Appends a frame in which a goal of the side has been given, its first one.
inline void score_goal(tests::ScriptedMatch& match, soccer::Side side) {
  const bool left = side == soccer::Side::kLeft;
  match.mode(left ? soccer::PlayMode::kGoalLeft : soccer::PlayMode::kGoalRight);
  match.score(left ? 1 : 0, left ? 0 : 1);
  match.step();
}

}  // namespace cls::analysis
