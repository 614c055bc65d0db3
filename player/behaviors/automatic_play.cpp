// Automatic play: before, instead of, and after a Playmaker's actions.
#include "player/behaviors/automatic_play.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "player/ball_skills/ball_skills.h"
#include "player/behaviors/behaviors.h"
#include "player/looking/looking.h"
#include "player/movement/home_positions.h"
#include "player/movement/movement.h"
#include "player/world/motion.h"

namespace cls::player {
namespace {

/// Reasons for automatic actions that replace the Playmaker's, by precedence
/// (docs/spec/proxy-behavior.md 2.4).
enum class PreprocessReason : unsigned char { kFrozen, kNoPlay, kPositionUnknown, kBallLost };

bool ball_lost(const WorldModel& world) {
  const int limit = world.goalie ? 10 : 5;
  const int seen_limit = world.goalie ? 20 : 15;
  return world.ball.pos_count > limit ||
         (world.game.mode != PlayMode::kPlayOn && world.ball.seen_pos_count > seen_limit);
}

std::optional<PreprocessReason> preprocess_reason(const WorldModel& world) {
  if (world.self.frozen()) return PreprocessReason::kFrozen;
  if (before_play(world.game.mode)) return PreprocessReason::kNoPlay;
  if (!world.self.position_valid()) return PreprocessReason::kPositionUnknown;
  if (ball_lost(world)) return PreprocessReason::kBallLost;
  return std::nullopt;
}

void preprocess(PreprocessReason reason, const WorldModel& world, const ViewMemory& view,
                CommandSlots& slots, NeckPlan& neck) {
  if (reason != PreprocessReason::kPositionUnknown) view_tactical(world, slots);

  switch (reason) {
    case PreprocessReason::kFrozen:
      neck.kind = NeckPlan::Kind::kBallOrScan;
      return;
    case PreprocessReason::kNoPlay:
      before_kick_off(world, view, slots, own_home_position(world));
      return;
    case PreprocessReason::kPositionUnknown:
      emergency(world, view, slots);
      return;
    case PreprocessReason::kBallLost:
      if (world.ball.ghost_count > 0) {
        scan_field(world, view, slots);  // not at the estimated position
      } else {
        neck_body_to_ball(world, view, slots, 0.0);
      }
  }
}

/// Possession continues after a kick ahead until another player controls the ball.
void update_possession(const WorldModel& world, ActionMemory& memory) {
  constexpr double kNear = 4.0;
  const bool open = world.game.mode == PlayMode::kPlayOn;
  const bool lost =
      world.kickable_teammate() || world.kickable_opponent() || world.ball.dist_from_self > kNear;

  if (!open || (lost && !world.self.kickable)) memory.ball_since = -1;
  if (open && world.self.kickable && memory.ball_since < 0) {
    memory.ball_since = world.game.time.cycle;
  }
}

bool run_preprocess(ActionContext& context) {
  const auto reason = preprocess_reason(context.world);
  if (reason) preprocess(*reason, context.world, context.memory.view, context.slots, context.neck);
  return reason.has_value();
}

bool run_sure_shot(ActionContext& context) {
  if (!shoot_and_look(context)) return false;
  context.memory.intention.clear();
  return true;
}

bool run_intention(ActionContext& context) {
  Intention& intention = context.memory.intention;
  switch (intention.kind) {
    case Intention::Kind::kNone:
      return false;
    case Intention::Kind::kReceive:
      return continue_reception(context);
    case Intention::Kind::kDribble:
      if (!continue_dribble(context.world, intention, context.slots)) return false;
      context.neck.kind = NeckPlan::Kind::kBallOrScan;
  }
  return true;
}

bool run_force_kick(ActionContext& context) {
  if (!force_kick(context.world, context.slots)) return false;
  context.neck.kind = NeckPlan::Kind::kScan;
  return true;
}

/// An automatic action: its switch, what it does, and where it is counted.
struct Step {
  bool AutomaticPlay::*enabled;
  bool (*run)(ActionContext& context);
  std::int64_t ActionReport::*count;
  DecidedBy by;
};

constexpr std::array<Step, 5> kSteps{{
    {&AutomaticPlay::preprocess, run_preprocess, &ActionReport::preprocess, DecidedBy::kPreprocess},
    {&AutomaticPlay::sure_shot, run_sure_shot, &ActionReport::sure_shot, DecidedBy::kSureShot},
    {&AutomaticPlay::intention, run_intention, &ActionReport::intention, DecidedBy::kIntention},
    {&AutomaticPlay::force_kick, run_force_kick, &ActionReport::force_kick, DecidedBy::kForceKick},
    {&AutomaticPlay::heard_pass, receive_heard_pass, &ActionReport::heard_pass,
     DecidedBy::kHeardPass},
}};

/// True if the action was taken, which is counted.
bool take(const Step& step, ActionContext& context) {
  if (!step.run(context)) return false;
  ++(context.report.*step.count);
  context.memory.trace.by = step.by;
  return true;
}

}  // namespace

bool shoot_and_look(ActionContext& context) {
  Vec2 aim;
  if (must_leave_ball(context.world, context.memory)) return false;
  if (!shoot(context.world, context.slots, &aim)) return false;
  context.neck = {NeckPlan::Kind::kPoint, aim};
  return true;
}

bool needs_preprocess(const WorldModel& world) { return preprocess_reason(world).has_value(); }

void begin_decision(ActionContext& context) {
  ActionMemory& memory = context.memory;
  memory.trace.outcomes.clear();
  update_view_memory(memory.view, context.world);
  update_possession(context.world, memory);
  update_set_play_kick(context.world, memory.set_play_kick);
}

bool play_automatically(ActionContext& context, const AutomaticPlay& enabled) {
  return std::ranges::any_of(
      kSteps, [&](const Step& step) { return enabled.*step.enabled && take(step, context); });
}

void decide_without_reply(ActionContext& context) {
  ActionMemory& memory = context.memory;
  memory.trace.outcomes.clear();
  update_view_memory(memory.view, context.world);
  if (!take(kSteps.front(), context)) context.neck.kind = NeckPlan::Kind::kBallOrScan;
  memory.trace.by = DecidedBy::kNoReply;
  finish_decision(context);
}

void finish_decision(ActionContext& context) {
  const WorldModel& world = context.world;
  if (!context.slots.view_requested()) view_tactical(world, context.slots);

  execute_neck_plan(context.neck, world, context.memory.view, context.slots);
  if (!context.slots.has_focus() && world.ball.position_valid()) {
    focus_to_point(world, context.slots, ball_after(world, 1));
  }

  communicate(context);
  record_set_play_kick(world, context.slots, context.memory.set_play_kick);
}

}  // namespace cls::player
