// Finds shots and their outcomes.
#include "analysis/play/shots.h"

#include <algorithm>
#include <cmath>

#include "base/text/enum_names.h"
#include "soccer/math.h"
#include "soccer/pitch.h"

namespace cls::analysis {
namespace {

using soccer::PlayMode;
using soccer::Vec2;

constexpr double kMaxDistance = 40.0;
constexpr double kMaxCycles = 15.0;
constexpr double kWideMargin = 2.0;
// A touch of the same player within these frames cancels the shot.
constexpr std::uint32_t kSecondTouchFrames = 3;
constexpr std::uint32_t kDeflectionFrames = 10;  // from an opponent's touch to the goal
constexpr double kPostRadius = 1.0;

constexpr auto kShotOutcomes =
    base::enum_names<ShotOutcome>("goal", "saved", "blocked", "wide", "post", "other");

bool goal_at(const Flow& flow, std::size_t frame, std::size_t team) {
  const PlayMode goal = team == 0 ? PlayMode::kGoalLeft : PlayMode::kGoalRight;
  return frame < flow.phase.size() && flow.record->mode[frame] == goal;
}

// True if the ball reversed near a post without a touch.
bool hit_post(const Flow& flow, std::size_t first, std::size_t last, double sign) {
  const gamelog::MatchRecord& record = *flow.record;
  const double half_width = record.server.goal_width / 2;

  for (std::size_t i = first + 1; i < std::min(last, record.frames()); ++i) {
    const Vec2 ball = Vec2(record.ball_position[i]) * sign;
    const Vec2 post = {soccer::kHalfLength, std::copysign(half_width, ball.y)};
    const bool reversed =
        record.ball_velocity[i - 1].x * sign > 0.0F && record.ball_velocity[i].x * sign < 0.0F;
    if (reversed && soccer::distance(ball, post) < kPostRadius) return true;
  }
  return false;
}

// True if the goal follows an opponent's touch so soon that it counts for the shot.
bool deflected_into_goal(const Flow& flow, std::size_t touch, std::size_t team) {
  const Touch& deflection = flow.touches[touch];
  const std::size_t end = flow.end_of_play(deflection);
  if (!goal_at(flow, end, team) || end - deflection.frame > kDeflectionFrames) return false;
  for (std::size_t i = touch; i < flow.touches.size() && flow.touches[i].frame <= end; ++i) {
    if (flow.touches[i].nearest[team] != kNoPlayer) return false;
  }
  return true;
}

// Sets the outcome. False if a teammate or the shooter touches next: then it was not a shot.
bool find_outcome(const Flow& flow, Shot& shot) {
  const Touch& touch = flow.touches[shot.touch];
  const std::size_t team = team_of(shot.slot);
  const std::size_t end = flow.end_of_play(touch);
  const std::size_t next = shot.touch + 1;

  if (next < flow.touches.size() && flow.touches[next].frame <= end) {
    const Touch& after = flow.touches[next];
    if (!after.contested() && same_team(after.slot, shot.slot)) return false;

    const std::int8_t opponent = after.nearest[1 - team];
    const std::size_t entry = entry_of(after.frame, slot_index(opponent));
    if (deflected_into_goal(flow, next, team)) {
      shot.outcome = ShotOutcome::kGoal;
    } else {
      shot.outcome = is_goalie(*flow.record, entry) ? ShotOutcome::kSaved : ShotOutcome::kBlocked;
    }
    return true;
  }

  if (goal_at(flow, end, team)) {
    shot.outcome = ShotOutcome::kGoal;
  } else if (hit_post(flow, touch.frame, end, attack_sign(shot.slot))) {
    shot.outcome = ShotOutcome::kPost;
  } else if (end < flow.phase.size() && flow.phase[end] == Phase::kSet) {
    shot.outcome = ShotOutcome::kWide;
  }
  return true;
}

bool touches_again(const Flow& flow, std::size_t touch, std::size_t slot) {
  const std::uint32_t last = flow.touches[touch].frame + kSecondTouchFrames;
  for (std::size_t i = touch + 1; i < flow.touches.size() && flow.touches[i].frame <= last; ++i) {
    if ((flow.touches[i].touchers >> slot & 1) != 0) return true;
  }
  return false;
}

}  // namespace

std::string_view name(ShotOutcome outcome) { return kShotOutcomes.name(outcome); }

bool heads_for_goal(const gamelog::MatchRecord& record, const Touch& touch, std::size_t slot,
                    Shot& shot) {
  if (touch.kind != TouchKind::kKick && touch.kind != TouchKind::kTackle) return false;

  const Vec2 from = touch.contact * attack_sign(slot);
  const Vec2 launch = touch.launch * attack_sign(slot);
  shot.distance = soccer::distance(from, {soccer::kHalfLength, 0.0});
  shot.speed = launch.length();
  if (launch.x <= 0.0 || shot.distance > kMaxDistance) return false;

  const double steps = std::max(0.0, (soccer::kHalfLength - from.x) / launch.x);
  shot.goal_y = from.y + steps * launch.y;
  const double decay = record.server.ball_decay;
  const double left_over = 1.0 - steps * (1.0 - decay);  // steps = distance / speed
  if (left_over <= 0.0 || decay <= 0.0 || decay >= 1.0) return false;
  shot.cycles = soccer::math::log(left_over) / soccer::math::log(decay);

  const double half_width = record.server.goal_width / 2;
  shot.on_target = std::fabs(shot.goal_y) <= half_width;
  return shot.cycles <= kMaxCycles && std::fabs(shot.goal_y) <= half_width + kWideMargin;
}

std::vector<Shot> find_shots(const Flow& flow) {
  std::vector<Shot> shots;
  for (std::size_t i = 0; i < flow.touches.size(); ++i) {
    const Touch& touch = flow.touches[i];
    if (touch.live_phase < 0) continue;
    for (const std::int8_t player : touch.nearest) {
      if (player == kNoPlayer) continue;
      const auto slot = slot_index(player);
      Shot shot;
      if (!heads_for_goal(*flow.record, touch, slot, shot)) continue;
      if (touches_again(flow, i, slot)) continue;

      shot.touch = static_cast<std::uint32_t>(i);
      shot.slot = player;
      if (find_outcome(flow, shot)) shots.push_back(shot);
    }
  }
  return shots;
}

}  // namespace cls::analysis
