// Sequence of the parts of a decision.
#include "proxy/actions/executor.h"

#include <google/protobuf/message.h>

#include <cmath>

#include "player/behaviors/automatic_play.h"
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

void count(player::ActionOutcome outcome, player::ActionCounts& counts) {
  switch (outcome) {
    case player::ActionOutcome::kExecuted:
      ++counts.done;
      return;
    case player::ActionOutcome::kFailed:
      ++counts.failed;
      return;
    case player::ActionOutcome::kSkipped:
      ++counts.skipped;
      return;
    case player::ActionOutcome::kInvalid:
      ++counts.invalid;
      return;
    case player::ActionOutcome::kUnimplemented:
      ++counts.unimplemented;
      return;
  }
}

/// Executes the list: main actions until one succeeds, all side actions.
void run_list(ReplyContext& context) {
  context.memory.trace.by = player::DecidedBy::kActions;
  bool main_done = false;
  bool any_done = false;
  for (const protos::PlayerAction& action : context.reply.actions()) {
    const int member = action.action_case();
    const ActionEntry& entry = action_entry(member);
    const player::ActionOutcome outcome = run_action(action, entry, main_done, context);
    count(outcome, context.report.actions[static_cast<std::size_t>(entry.member)]);
    context.memory.trace.outcomes.push_back(outcome);
    const bool success = outcome == player::ActionOutcome::kExecuted;
    any_done = any_done || success;
    main_done = main_done || (success && entry.kind == ActionClass::kMain);
  }
  ++context.report.lists;
  if (context.reply.actions().empty()) ++context.report.empty;
  if (!any_done) ++context.report.useless;
}

}  // namespace

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

void execute_without_reply(const player::WorldModel& world, player::ActionMemory& memory,
                           player::CommandSlots& slots, player::ActionReport& report) {
  player::NeckPlan neck;
  player::PlanChoice choice;
  player::ActionContext context{world, memory, slots, neck, report, choice};
  decide_without_reply(context);
}

}  // namespace cls::proxy
