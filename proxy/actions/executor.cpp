// Sequence of the parts of a decision.
#include "proxy/actions/executor.h"

#include <google/protobuf/message.h>

#include <cmath>
#include <optional>

#include "proto/playmaker.pb.h"
#include "proxy/actions/action_handlers.h"
#include "proxy/ball_skills/clear_ball.h"
#include "proxy/ball_skills/dribble.h"
#include "proxy/ball_skills/shoot.h"
#include "proxy/behaviors/behaviors.h"
#include "proxy/looking/body_neck.h"
#include "proxy/looking/view.h"
#include "proxy/movement/home_positions.h"
#include "proxy/movement/movement.h"
#include "proxy/world/motion.h"

namespace cls::proxy {
namespace {

namespace pb = google::protobuf;
using soccer::PlayMode;

/// Reasons for automatic actions that replace the Playmaker's, by precedence
/// (docs/spec/proxy-behavior.md 2.4).
enum class PreprocessReason : unsigned char { kFrozen, kNoPlay, kPositionUnknown, kBallLost };

bool no_play(PlayMode mode) {
  return mode == PlayMode::kBeforeKickOff || mode == PlayMode::kGoalLeft ||
         mode == PlayMode::kGoalRight;
}

bool ball_lost(const WorldModel& world) {
  const int limit = world.goalie ? 10 : 5;
  const int seen_limit = world.goalie ? 20 : 15;
  return world.ball.pos_count > limit ||
         (world.game.mode != PlayMode::kPlayOn && world.ball.seen_pos_count > seen_limit);
}

std::optional<PreprocessReason> preprocess_reason(const WorldModel& world) {
  if (world.self.frozen()) return PreprocessReason::kFrozen;
  if (no_play(world.game.mode)) return PreprocessReason::kNoPlay;
  if (!world.self.position_valid()) return PreprocessReason::kPositionUnknown;
  if (ball_lost(world)) return PreprocessReason::kBallLost;
  return std::nullopt;
}

void preprocess(PreprocessReason reason, const WorldModel& world, const ViewMemory& view,
                CommandSlots& slots, NeckPlan& neck) {
  switch (reason) {
    case PreprocessReason::kFrozen:
      view_tactical(world, slots);
      neck.kind = NeckPlan::Kind::kBallOrScan;
      return;
    case PreprocessReason::kNoPlay:
      view_tactical(world, slots);
      before_kick_off(world, view, slots, own_home_position(world));
      return;
    case PreprocessReason::kPositionUnknown:
      emergency(world, view, slots);
      return;
    case PreprocessReason::kBallLost:
      view_tactical(world, slots);
      if (world.ball.ghost_count > 0) {
        scan_field(world, view, slots);  // not at the estimated position
      } else {
        neck_body_to_ball(world, view, slots, 0.0);
      }
      return;
  }
}

bool finite_field(const pb::Message& message, const pb::Reflection& reflection,
                  const pb::FieldDescriptor& field);

/// False when any number in the message, at any depth, is infinite or not a number.
bool all_finite(const pb::Message& message) {
  const pb::Descriptor& type = *message.GetDescriptor();
  const pb::Reflection& reflection = *message.GetReflection();
  // An action is one of 60 fields: ask for the set one instead of each.
  for (int i = 0; i < type.real_oneof_decl_count(); ++i) {
    const auto* set = reflection.GetOneofFieldDescriptor(message, type.oneof_decl(i));
    if (set != nullptr && !finite_field(message, reflection, *set)) return false;
  }
  for (int i = 0; i < type.field_count(); ++i) {
    const pb::FieldDescriptor& field = *type.field(i);
    if (field.real_containing_oneof() == nullptr && !finite_field(message, reflection, field)) {
      return false;
    }
  }
  return true;
}

bool finite_field(const pb::Message& message, const pb::Reflection& reflection,
                  const pb::FieldDescriptor& field) {
  const bool number = field.cpp_type() == pb::FieldDescriptor::CPPTYPE_FLOAT;
  const bool nested = field.cpp_type() == pb::FieldDescriptor::CPPTYPE_MESSAGE;
  if (field.is_repeated()) {
    const int size = number || nested ? reflection.FieldSize(message, &field) : 0;
    for (int i = 0; i < size; ++i) {
      if (number && !std::isfinite(reflection.GetRepeatedFloat(message, &field, i))) return false;
      if (nested && !all_finite(reflection.GetRepeatedMessage(message, &field, i))) return false;
    }
    return true;
  }
  if (number) return std::isfinite(reflection.GetFloat(message, &field));
  if (nested && reflection.HasField(message, &field)) {
    return all_finite(reflection.GetMessage(message, &field));
  }
  return true;
}

/// Possession continues after a kick ahead until another player controls the ball.
void update_possession(const WorldModel& world, ActionMemory& memory) {
  constexpr double kNear = 4.0;
  const bool open = world.game.mode == soccer::PlayMode::kPlayOn;
  const bool lost =
      world.kickable_teammate() || world.kickable_opponent() || world.ball.dist_from_self > kNear;
  if (!open || (lost && !world.self.kickable)) memory.ball_since = -1;
  if (open && world.self.kickable && memory.ball_since < 0) {
    memory.ball_since = world.game.time.cycle;
  }
}

ActionOutcome run_action(const protos::PlayerAction& action, const ActionEntry& entry,
                         bool main_done, ActionContext& context) {
  if (entry.kind == ActionClass::kMain && main_done) return ActionOutcome::kSkipped;
  if (entry.handler == nullptr) return ActionOutcome::kUnimplemented;
  if (!all_finite(action)) return ActionOutcome::kInvalid;
  return entry.handler(action, context) ? ActionOutcome::kExecuted : ActionOutcome::kFailed;
}

void count(ActionOutcome outcome, ActionCounts& counts) {
  switch (outcome) {
    case ActionOutcome::kExecuted:
      ++counts.done;
      return;
    case ActionOutcome::kFailed:
      ++counts.failed;
      return;
    case ActionOutcome::kSkipped:
      ++counts.skipped;
      return;
    case ActionOutcome::kInvalid:
      ++counts.invalid;
      return;
    case ActionOutcome::kUnimplemented:
      ++counts.unimplemented;
      return;
  }
}

/// Executes the list: main actions until one succeeds, all side actions.
void run_list(const protos::PlayerActions& reply, ActionContext& context) {
  context.memory.trace.by = DecidedBy::kActions;
  bool main_done = false;
  bool any_done = false;
  for (const protos::PlayerAction& action : reply.actions()) {
    const int member = action.action_case();
    const ActionEntry& entry = action_entry(member);
    const ActionOutcome outcome = run_action(action, entry, main_done, context);
    count(outcome, context.report.actions[static_cast<std::size_t>(entry.member)]);
    context.memory.trace.outcomes.push_back(outcome);
    const bool success = outcome == ActionOutcome::kExecuted;
    any_done = any_done || success;
    main_done = main_done || (success && entry.kind == ActionClass::kMain);
  }
  ++context.report.lists;
  if (reply.actions().empty()) ++context.report.empty;
  if (!any_done) ++context.report.useless;
}

bool run_preprocess(ActionContext& context) {
  const auto reason = preprocess_reason(context.world);
  if (!reason) return false;
  preprocess(*reason, context.world, context.memory.view, context.slots, context.neck);
  ++context.report.preprocess;
  context.memory.trace.by = DecidedBy::kPreprocess;
  return true;
}

bool run_sure_shot(ActionContext& context) {
  soccer::Vec2 aim;
  if (!shoot(context.world, context.slots, &aim)) return false;
  context.memory.intention.clear();
  context.neck = {NeckPlan::Kind::kPoint, aim};
  ++context.report.sure_shot;
  context.memory.trace.by = DecidedBy::kSureShot;
  return true;
}

bool run_intention(ActionContext& context) {
  Intention& intention = context.memory.intention;
  switch (intention.kind) {
    case Intention::Kind::kNone:
      return false;
    case Intention::Kind::kReceive:
      if (!continue_reception(context)) return false;
      break;
    case Intention::Kind::kDribble:
      if (!continue_dribble(context.world, intention, context.slots)) return false;
      context.neck.kind = NeckPlan::Kind::kBallOrScan;
      break;
  }
  ++context.report.intention;
  context.memory.trace.by = DecidedBy::kIntention;
  return true;
}

bool run_heard_pass(ActionContext& context) {
  if (!receive_heard_pass(context)) return false;
  ++context.report.heard_pass;
  context.memory.trace.by = DecidedBy::kHeardPass;
  return true;
}

bool run_force_kick(ActionContext& context) {
  if (!force_kick(context.world, context.slots)) return false;
  context.neck.kind = NeckPlan::Kind::kScan;
  ++context.report.force_kick;
  context.memory.trace.by = DecidedBy::kForceKick;
  return true;
}

/// Ends every decision: queued neck plan, default view width and focus, communication.
void finish(ActionContext& context) {
  const WorldModel& world = context.world;
  if (!context.slots.view_requested()) view_tactical(world, context.slots);
  execute_neck_plan(context.neck, world, context.memory.view, context.slots);
  if (!context.slots.has_focus() && world.ball.position_valid()) {
    focus_to_point(world, context.slots, ball_after(world, 1));
  }
  communicate(context);
}

}  // namespace

bool needs_preprocess(const WorldModel& world) { return preprocess_reason(world).has_value(); }

void execute(const protos::PlayerActions& reply, const WorldModel& world, ActionMemory& memory,
             CommandSlots& slots, ActionReport& report, PlanChoice& choice) {
  NeckPlan neck;
  ActionContext context{world, memory, slots, neck, report, choice, &reply};
  memory.debug.clear();
  memory.trace.outcomes.clear();
  update_view_memory(memory.view, world);
  update_possession(world, memory);
  const bool automatic = (!reply.ignore_preprocess() && run_preprocess(context)) ||
                         (!reply.ignore_shootinpreprocess() && run_sure_shot(context)) ||
                         (!reply.ignore_dointention() && run_intention(context)) ||
                         (!reply.ignore_doforcekick() && run_force_kick(context)) ||
                         (!reply.ignore_doheardpassrecieve() && run_heard_pass(context));
  if (!automatic) run_list(reply, context);
  if (choice.chooser != PlanChoice::Chooser::kRequested) finish(context);
}

void execute(const protos::PlayerActions& reply, const WorldModel& world, ActionMemory& memory,
             CommandSlots& slots, ActionReport& report) {
  PlanChoice choice;
  execute(reply, world, memory, slots, report, choice);
}

void execute_without_reply(const WorldModel& world, ActionMemory& memory, CommandSlots& slots,
                           ActionReport& report) {
  NeckPlan neck;
  PlanChoice choice;
  ActionContext context{world, memory, slots, neck, report, choice};
  memory.debug.clear();
  memory.trace.outcomes.clear();
  update_view_memory(memory.view, world);
  if (!run_preprocess(context)) neck.kind = NeckPlan::Kind::kBallOrScan;
  memory.trace.by = DecidedBy::kNoReply;
  finish(context);
}

}  // namespace cls::proxy
