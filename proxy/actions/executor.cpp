// Sequence of the parts of a decision.
#include "proxy/actions/executor.h"

#include <google/protobuf/message.h>

#include <cmath>

#include "base/index.h"
#include "player/behaviors/automatic_play.h"
#include "player/movement/home_positions.h"
#include "proto/playmaker.pb.h"
#include "proxy/actions/action_handlers.h"

namespace cls::proxy {
namespace {

namespace pb = google::protobuf;

bool finite_field(const pb::Message& message, const pb::Reflection& reflection,
                  const pb::FieldDescriptor& field);

/// False when any number in the message, at any depth, is infinite or not a number.
bool all_finite(const pb::Message& message) {
  const pb::Descriptor& type = *message.GetDescriptor();
  const pb::Reflection& reflection = *message.GetReflection();

  // An action is one of 60 fields: ask for the set one instead of each.
  int in_oneofs = 0;
  for (int i = 0; i < type.real_oneof_decl_count(); ++i) {
    in_oneofs += type.oneof_decl(i)->field_count();
    const auto* set = reflection.GetOneofFieldDescriptor(message, type.oneof_decl(i));
    if (set != nullptr && !finite_field(message, reflection, *set)) return false;
  }
  if (in_oneofs == type.field_count()) return true;

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

player::ActionOutcome run_action(const protos::PlayerAction& action, const ActionEntry& entry,
                                 bool main_done, ReplyContext& context) {
  if (entry.kind == ActionClass::kMain && main_done) return player::ActionOutcome::kSkipped;
  if (entry.handler == nullptr) return player::ActionOutcome::kUnimplemented;
  if (!all_finite(action)) return player::ActionOutcome::kInvalid;
  return entry.handler(action, context) ? player::ActionOutcome::kExecuted
                                        : player::ActionOutcome::kFailed;
}

std::int64_t& count_of(player::ActionOutcome outcome, player::ActionCounts& counts) {
  switch (outcome) {
    case player::ActionOutcome::kExecuted:
      return counts.done;
    case player::ActionOutcome::kFailed:
      return counts.failed;
    case player::ActionOutcome::kSkipped:
      return counts.skipped;
    case player::ActionOutcome::kInvalid:
      return counts.invalid;
    case player::ActionOutcome::kUnimplemented:
      break;
  }

  return counts.unimplemented;
}

/// Executes the list: main actions until one succeeds, all side actions.
void run_list(ReplyContext& context) {
  context.memory.trace.by = player::DecidedBy::kActions;
  bool main_done = false;
  bool any_done = false;
  for (const protos::PlayerAction& action : context.reply.actions()) {
    const ActionEntry& entry = action_entry(action.action_case());
    const player::ActionOutcome outcome = run_action(action, entry, main_done, context);
    ++count_of(outcome, context.report.actions[base::index(entry.member)]);
    context.memory.trace.outcomes.push_back(outcome);
    const bool success = outcome == player::ActionOutcome::kExecuted;
    any_done = any_done || success;
    main_done = main_done || (success && entry.kind == ActionClass::kMain);
  }

  ++context.report.lists;
  if (context.reply.actions().empty()) ++context.report.empty;
  if (!any_done) ++context.report.useless;
}

void go_home(const player::WorldModel& world, protos::PlayerActions& out) {
  constexpr float kHomeDistance = 1.0F;
  constexpr float kRunningPower = 70.0F;
  const soccer::Vec2 home = own_home_position(world);
  protos::Body_GoToPoint& go = *out.add_actions()->mutable_body_go_to_point();
  go.mutable_target_point()->set_x(static_cast<float>(home.x));
  go.mutable_target_point()->set_y(static_cast<float>(home.y));
  go.set_distance_threshold(kHomeDistance);
  go.set_max_dash_power(kRunningPower);
}

}  // namespace

void choose_fallback_actions(const player::WorldModel& world, protos::PlayerActions& out) {
  out.Clear();
  const player::InterceptTable& table = world.intercept;
  const bool may_touch = !is_set_play_of(world.game, world.their_side());
  const bool first =
      table.self_steps < player::kNever && table.self_steps <= table.first_teammate_steps;

  if (world.self.kickable) {
    out.add_actions()->mutable_body_clear_ball();
  } else if (may_touch && first) {
    out.add_actions()->mutable_body_intercept();
  } else {
    go_home(world, out);
    out.add_actions()->mutable_body_turn_to_ball();
  }
  out.add_actions()->mutable_neck_turn_to_ball_or_scan();
}

void execute(const protos::PlayerActions& reply, const player::WorldModel& world,
             player::ActionMemory& memory, player::CommandSlots& slots,
             player::ActionReport& report, player::PlanChoice& choice) {
  player::NeckPlan neck;
  ReplyContext context{{world, memory, slots, neck, report, choice}, reply};
  player::begin_decision(context);

  player::AutomaticPlay automatic;
  automatic.preprocess = !reply.ignore_preprocess();
  automatic.sure_shot = !reply.ignore_shootinpreprocess();
  automatic.intention = !reply.ignore_dointention();
  automatic.force_kick = !reply.ignore_doforcekick();
  automatic.heard_pass = !reply.ignore_doheardpassrecieve();

  if (!play_automatically(context, automatic)) run_list(context);
  if (choice.chooser != player::PlanChoice::Chooser::kRequested) player::finish_decision(context);
}

void execute(const protos::PlayerActions& reply, const player::WorldModel& world,
             player::ActionMemory& memory, player::CommandSlots& slots,
             player::ActionReport& report) {
  player::PlanChoice choice;
  execute(reply, world, memory, slots, report, choice);
}

void execute_own_play(const OwnPlay& play, const player::WorldModel& world,
                      player::ActionMemory& memory, player::CommandSlots& slots,
                      player::ActionReport& report, player::PlanChoice& choice) {
  player::NeckPlan neck;
  player::ActionContext context{world, memory, slots, neck, report, choice};
  player::begin_decision(context);
  memory.trace.by = player::DecidedBy::kOwnPlay;
  play(context);
  player::finish_decision(context);
}

void execute_without_reply(const player::WorldModel& world, player::ActionMemory& memory,
                           player::CommandSlots& slots, player::ActionReport& report) {
  player::NeckPlan neck;
  player::PlanChoice choice;
  player::ActionContext context{world, memory, slots, neck, report, choice};
  decide_without_reply(context);
}

}  // namespace cls::proxy
