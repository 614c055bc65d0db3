// Finds and classifies passes.
#include "analysis/play/passes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/play/one_ball.h"
#include "analysis/play/pitch_areas.h"
#include "base/text/enum_names.h"
#include "soccer/pitch.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

constexpr double kPlayedSpeed = 0.6;
constexpr int kOneTwoCycles = 40;
constexpr double kOneTwoGain = 5.0;

constexpr auto kPassOutcomes = base::enum_names<PassOutcome>(
    "completed", "intercepted", "contested", "out", "offside", "stopped");

PassDirection direction_of(Vec2 path) {
  if (path.x >= std::fabs(path.y)) return PassDirection::kForward;
  if (-path.x >= std::fabs(path.y)) return PassDirection::kBack;
  return path.y < 0.0 ? PassDirection::kLeft : PassDirection::kRight;
}

Vec2 seen(const gamelog::MatchRecord& record, std::size_t entry, double sign) {
  return Vec2(record.players.position[entry]) * sign;
}

// Classifies a pass by the frames in which it leaves and arrives.
class PassClassifier {
 public:
  PassClassifier(const gamelog::MatchRecord& record, std::size_t launch, std::size_t end,
                 Pass& pass)
      : record_(record),
        launch_(launch),
        end_(end),
        pass_(pass),
        team_(team_of(pass.passer)),
        sign_(attack_sign(pass.passer)) {}

  void mark_completed() {
    const auto receiver = slot_index(pass_.receiver);
    const double line = offside_line(record_, launch_, team_);
    const double start_x = seen(record_, entry_of(launch_, receiver), sign_).x;

    pass_.through =
        start_x <= line + 0.5 && pass_.to.x > line && pass_.gain() >= 5.0 && pass_.to.x > 15.0;
    pass_.cutback = pass_.from.x > 44.0 && pass_.gain() < 0.0 && pass_.to.x > 36.0 &&
                    std::fabs(pass_.to.y) < 16.0;

    const Vec2 reception = seen(record_, entry_of(end_, receiver), sign_);
    pass_.nearest_opponent = std::numeric_limits<double>::max();

    for (const std::size_t slot : kTeamSlots[1 - team_]) {
      if (!gamelog::is_enabled(record_, entry_of(end_, slot))) continue;
      const Vec2 now = seen(record_, entry_of(end_, slot), sign_);
      const double before_x = seen(record_, entry_of(launch_, slot), sign_).x;
      pass_.nearest_opponent = std::min(pass_.nearest_opponent, soccer::distance(now, reception));
      pass_.overtaken += before_x > pass_.from.x && before_x < pass_.to.x && now.x < pass_.to.x;
    }
    if (pass_.nearest_opponent > soccer::kPitchLength * 2) pass_.nearest_opponent = 0.0;
  }

  void mark_attempt() {
    pass_.cross = std::fabs(pass_.from.y) > 20.0 && pass_.from.x > 30.0 &&
                  std::fabs(pass_.to.y) < 16.0 && pass_.to.x > 36.0;
    pass_.switched = pass_.length() > 25.0 && std::fabs(pass_.to.y - pass_.from.y) > 20.0;
    pass_.clearance = is_clearance();
  }

 private:
  // True for a hard kick out of the own third that leaves the pitch or lands away from all
  // teammates.
  bool is_clearance() const {
    if (pass_.completed() || pass_.from.x > -kThirdBorder || pass_.speed < 2.0) return false;

    const double range = pass_.speed / (1.0 - record_.server.ball_decay);
    const Vec2 launch = record_.ball_position[launch_ + 1];
    const Vec2 path = launch * sign_ - pass_.from;
    const double length = path.length();
    if (length == 0.0) return false;

    const Vec2 landing = pass_.from + path * (range / length);
    if (std::fabs(landing.x) > soccer::kHalfLength || std::fabs(landing.y) > soccer::kHalfWidth) {
      return true;
    }

    if (landing.x - pass_.from.x <= 25.0) return false;
    for (const std::size_t slot : kTeamSlots[team_]) {
      const std::size_t entry = entry_of(launch_, slot);
      if (gamelog::is_enabled(record_, entry) &&
          soccer::distance(seen(record_, entry, sign_), landing) <= 10.0) {
        return false;
      }
    }
    return true;
  }

  const gamelog::MatchRecord& record_;
  std::size_t launch_;
  std::size_t end_;
  Pass& pass_;
  std::size_t team_;
  double sign_;
};

PassOutcome outcome_of_dead_ball(const Flow& flow, std::size_t end) {
  switch (soccer::without_side(flow.record->mode[end])) {
    case soccer::PlayMode::kOffsideLeft:
      return PassOutcome::kOffside;
    case soccer::PlayMode::kKickInLeft:
    case soccer::PlayMode::kCornerKickLeft:
    case soccer::PlayMode::kGoalKickLeft:
      return PassOutcome::kOut;
    default:
      return PassOutcome::kStopped;
  }
}

// A touch from an offside position does not complete a pass.
bool offside_at(const Flow& flow, const Touch& touch, std::size_t team) {
  const soccer::PlayMode mode = flow.record->mode[touch.frame];
  return mode == (team == 0 ? soccer::PlayMode::kOffsideLeft : soccer::PlayMode::kOffsideRight);
}

struct PassBuilder {
  const Flow& flow;

  // Builds the pass of a touch. The next touch or stoppage decides the outcome.
  Pass build(std::size_t index) const {
    const Touch& touch = flow.touches[index];
    const gamelog::MatchRecord& record = *flow.record;
    const double sign = attack_sign(touch.slot);

    Pass pass = {.touch = static_cast<std::uint32_t>(index),
                 .passer = touch.slot,
                 .from = touch.contact * sign,
                 .speed = touch.launch.length()};

    const Touch* next = next_in_play(index);
    std::size_t end = 0;
    if (next != nullptr) {
      end = next->frame - 1;  // position of the ball when it was touched
      pass.to = next->contact * sign;
      pass.receiver = next->slot;
      pass.outcome = offside_at(flow, *next, team_of(touch.slot)) ? PassOutcome::kOffside
                     : next->contested()                          ? PassOutcome::kContested
                     : same_team(touch.slot, next->slot)          ? PassOutcome::kCompleted
                                                                  : PassOutcome::kIntercepted;
    } else {
      end = std::min(flow.end_of_play(touch), record.frames() - 1);
      // A dropped ball was moved by the referee: the pass ended in the frame before.
      const bool dropped = std::ranges::binary_search(flow.placed, end);
      pass.to = Vec2(record.ball_position[dropped ? end - 1 : end]) * sign;
      pass.outcome = outcome_of_dead_ball(flow, end);
    }

    pass.frames = static_cast<std::uint32_t>(end + 1 - touch.frame);
    pass.direction = direction_of(pass.to - pass.from);
    PassClassifier view(record, touch.frame - 1, end, pass);
    if (pass.completed()) view.mark_completed();
    view.mark_attempt();
    return pass;
  }

  const Touch* next_in_play(std::size_t index) const {
    if (index + 1 >= flow.touches.size()) return nullptr;
    const Touch& next = flow.touches[index + 1];
    return next.live_phase == flow.touches[index].live_phase ? &next : nullptr;
  }
};

bool was_played(const Pass& pass) {
  return pass.completed() || pass.speed >= kPlayedSpeed || pass.length() >= kPlayedDistance;
}

}  // namespace

double offside_line(const gamelog::MatchRecord& record, std::size_t frame,
                    std::size_t attacking_team) {
  const double sign = attacking_team == 0 ? 1.0 : -1.0;
  double last = 0.0;  // opponents behind the half line do not count
  double second = 0.0;

  for (const std::size_t slot : kTeamSlots[1 - attacking_team]) {
    const std::size_t entry = entry_of(frame, slot);
    if (!gamelog::is_enabled(record, entry)) continue;
    const double x = record.players.position[entry].x * sign;
    if (x > last) {
      second = last;
      last = x;
    } else {
      second = std::max(second, x);
    }
  }
  return std::max({second, 0.0, record.ball_position[frame].x * sign});
}

std::string_view name(PassOutcome outcome) { return kPassOutcomes.name(outcome); }

std::vector<Pass> find_passes(const Flow& flow, const std::vector<Shot>& shots) {
  std::vector<Pass> passes;
  const PassBuilder builder{flow};
  auto shot = shots.begin();

  for (std::size_t i = 0; i < flow.touches.size(); ++i) {
    while (shot != shots.end() && shot->touch < i) ++shot;
    const Touch& touch = flow.touches[i];
    const bool played = touch.kind == TouchKind::kKick || touch.kind == TouchKind::kTackle;
    const bool is_shot = shot != shots.end() && shot->touch == i;
    if (touch.live_phase < 0 || touch.contested() || !played || is_shot) continue;

    const Touch* next = builder.next_in_play(i);
    if (next != nullptr && next->slot == touch.slot) continue;  // a carry
    if (next != nullptr && at_one_ball(flow, touch, *next)) continue;

    const Pass pass = builder.build(i);
    if (was_played(pass)) passes.push_back(pass);
  }
  return passes;
}

PerTeam<int> one_twos(const Flow& flow, const std::vector<Pass>& passes) {
  PerTeam<int> count = {};
  for (std::size_t i = 0; i + 1 < passes.size(); ++i) {
    const Pass& there = passes[i];
    const Pass& back = passes[i + 1];
    if (!there.completed() || !back.completed() || back.receiver != there.passer ||
        back.passer != there.receiver) {
      continue;
    }

    const Touch& first = flow.touches[there.touch];
    const Touch& second = flow.touches[back.touch];
    const bool one_phase = first.live_phase == second.live_phase;
    const auto frames = second.frame + back.frames - first.frame;
    if (one_phase && frames <= kOneTwoCycles && back.to.x - there.from.x >= kOneTwoGain) {
      ++count[team_of(there.passer)];
    }
  }
  return count;
}

}  // namespace cls::analysis
