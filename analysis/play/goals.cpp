// Finds goals and their scorers.
#include <algorithm>

#include "analysis/play/shots.h"

namespace cls::analysis {
namespace {

using soccer::Side;

constexpr std::int32_t kDeflectionCycles = 5;

// The shot that led to a goal: the last one of the side before it.
std::int32_t shot_before(const Flow& flow, const std::vector<Shot>& shots, const Goal& goal,
                         std::size_t team) {
  for (std::size_t i = shots.size(); i > 0; --i) {
    const Shot& shot = shots[i - 1];
    const std::uint32_t frame = flow.touches[shot.touch].frame;
    if (frame > goal.frame || team_of(shot.slot) != team) continue;

    const bool this_one = shot.outcome == ShotOutcome::kGoal &&
                          (goal.frame == frame ||
                           flow.live_phase[goal.frame - 1] == flow.touches[shot.touch].live_phase);
    return this_one ? static_cast<std::int32_t>(i - 1) : -1;
  }
  return -1;
}

// The goalie's touch just after a shot on target does not take the goal from the shooter.
std::int8_t shooter_deflected_by(const Flow& flow, std::size_t touch, std::size_t team) {
  const gamelog::MatchRecord& record = *flow.record;
  const Touch& deflection = flow.touches[touch];
  for (std::size_t i = touch; i > 0; --i) {
    const Touch& before = flow.touches[i - 1];
    const std::int8_t shooter = before.nearest[team];
    if (record.time[deflection.frame] - record.time[before.frame] > kDeflectionCycles) break;
    if (shooter == kNoPlayer) continue;

    Shot shot;
    const bool on_target =
        heads_for_goal(record, before, slot_index(shooter), shot) && shot.on_target;
    return on_target && deflection.kind != TouchKind::kKick ? shooter : kNoPlayer;
  }
  return kNoPlayer;
}

void find_scorer(const Flow& flow, std::size_t team, Goal& goal) {
  std::size_t last = flow.touches.size();
  while (last > 0 && flow.touches[last - 1].frame > goal.frame) --last;
  if (last == 0) return;

  const Touch& touch = flow.touches[last - 1];
  const bool in_play =
      goal.frame > 0 && touch.live_phase >= 0 &&
      (touch.frame == goal.frame || touch.live_phase == flow.live_phase[goal.frame - 1]);
  if (!in_play) return;

  if (touch.nearest[team] != kNoPlayer) {
    goal.scorer = touch.nearest[team];
    return;
  }

  goal.scorer = shooter_deflected_by(flow, last - 1, team);
  if (goal.scorer != kNoPlayer) return;
  goal.scorer = touch.nearest[1 - team];
  goal.own_goal = true;
}

void add_goals(const Flow& flow, const std::vector<Shot>& shots, const gamelog::TeamFrames& before,
               const gamelog::TeamFrames& now, Goal goal, std::vector<Goal>& goals) {
  for (std::size_t team = 0; team < 2; ++team) {
    if (now[team].score <= before[team].score || now[team].name.empty()) continue;
    goal.side = team == 0 ? Side::kLeft : Side::kRight;
    goal.shot = shot_before(flow, shots, goal, team);
    if (goal.shot >= 0) {
      goal.scorer = shots[base::index(goal.shot)].slot;
    } else {
      find_scorer(flow, team, goal);
    }

    // Only a trainer can raise a score by more than one.
    for (int i = before[team].score; i < std::min(now[team].score, before[team].score + 100); ++i) {
      goals.push_back(goal);
    }
  }
}

}  // namespace

std::vector<Goal> find_goals(const Flow& flow, const std::vector<Shot>& shots) {
  std::vector<Goal> goals;
  const gamelog::MatchRecord& record = *flow.record;
  if (record.frames() == 0) return goals;

  Goal goal;
  for (std::size_t i = 1; i < record.frames(); ++i) {
    const std::uint32_t before = record.team_state[i - 1];
    const std::uint32_t now = record.team_state[i];
    if (before == now || before == 0) continue;
    goal.frame = static_cast<std::uint32_t>(i);
    goal.cycle = record.time[i];
    add_goals(flow, shots, record.teams[before], record.teams[now], goal, goals);
  }

  // A golden goal ends the match before another frame is written.
  const std::uint32_t last = record.team_state[record.frames() - 1];
  goal.frame = static_cast<std::uint32_t>(record.frames() - 1);
  goal.cycle = record.time.back();
  if (last != 0) add_goals(flow, shots, record.teams[last], record.final_teams(), goal, goals);
  return goals;
}

}  // namespace cls::analysis
