// Steps: every decision RPC, and whether the reply is usable.
#include <fmt/format.h>
#include <google/protobuf/unknown_field_set.h>

#include <algorithm>
#include <cmath>

#include "checks/playmaker/playmaker_subject.h"
#include "checks/playmaker/sample_states.h"

namespace cls::checks {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;
using proto::Rpc;

constexpr std::size_t kMaxReplyBytes = 64 * 1024;

// "kick.power is nan"; empty if all numbers are finite.
std::string not_finite(const Message& message);

std::string not_finite_in(const Message& message, const FieldDescriptor& field) {
  const Reflection& reflection = *message.GetReflection();
  const int count = field.is_repeated() ? reflection.FieldSize(message, &field) : 1;
  for (int i = 0; i < count; ++i) {
    double value = 0.0;
    if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      const std::string inner =
          not_finite(field.is_repeated() ? reflection.GetRepeatedMessage(message, &field, i)
                                         : reflection.GetMessage(message, &field));
      if (!inner.empty()) return field.name() + "." + inner;
    } else if (field.cpp_type() == FieldDescriptor::CPPTYPE_FLOAT) {
      value = field.is_repeated() ? reflection.GetRepeatedFloat(message, &field, i)
                                  : reflection.GetFloat(message, &field);
    } else if (field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) {
      value = field.is_repeated() ? reflection.GetRepeatedDouble(message, &field, i)
                                  : reflection.GetDouble(message, &field);
    }

    if (!std::isfinite(value)) return fmt::format("{} is {}", field.name(), value);
  }

  return {};
}

std::string not_finite(const Message& message) {
  std::vector<const FieldDescriptor*> fields;
  message.GetReflection()->ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    const std::string found = not_finite_in(message, *field);
    if (!found.empty()) return found;
  }
  return {};
}

std::string kinds(const protos::PlayerActions& actions) {
  std::string text;
  for (const protos::PlayerAction& action : actions.actions()) {
    const auto* oneof = action.GetDescriptor()->oneof_decl(0);
    const FieldDescriptor* member = action.GetReflection()->GetOneofFieldDescriptor(action, oneof);
    text += (text.empty() ? "" : ", ") + (member == nullptr ? "nothing" : member->name());
  }
  return text.empty() ? "no action" : text;
}

Finding player_actions(PlaymakerSubject& subject) {
  const Answer answer = ask(subject, kAgent, subject.next_state(kAgent));
  return finding(answer.status, kinds(answer.actions));
}

// Asks 11 players. `wrong` says what is wrong with the actions of a reply; empty: nothing.
Finding ask_players(PlaymakerSubject& subject, const std::string& evidence,
                    std::string (*wrong)(const protos::PlayerActions&)) {
  for (int agent = 1; agent <= 11; ++agent) {
    const Answer answer = ask(subject, agent, subject.next_state(agent));
    const std::string found = answer.status.ok() ? wrong(answer.actions) : to_text(answer.status);
    if (!found.empty()) return fail("player {}: {}", agent, found);
  }
  return pass(evidence);
}

// The kinds of all actions, if one of them is unknown.
std::string unknown_kinds(const protos::PlayerActions& actions) {
  const bool known = std::ranges::all_of(actions.actions(), [](const auto& action) {
    return action.GetReflection()->GetUnknownFields(action).empty() &&
           action.action_case() != protos::PlayerAction::ACTION_NOT_SET;
  });
  return known ? "" : kinds(actions);
}

Finding known_actions(PlaymakerSubject& subject) {
  return ask_players(subject, "11 players, only known actions", unknown_kinds);
}

Finding finite_numbers(PlaymakerSubject& subject) {
  return ask_players(subject, "11 players, all numbers finite",
                     [](const protos::PlayerActions& actions) { return not_finite(actions); });
}

Finding reply_size(PlaymakerSubject& subject) {
  const Answer answer = ask(subject, kAgent, subject.next_state(kAgent));
  if (!answer.status.ok()) return fail(to_text(answer.status));
  const std::string evidence = fmt::format("{} actions in {} bytes", answer.actions.actions_size(),
                                           answer.actions.ByteSizeLong());
  return answer.actions.ByteSizeLong() <= kMaxReplyBytes ? pass(evidence) : fail(evidence);
}

Finding same_question(PlaymakerSubject& subject) {
  const protos::State state = subject.next_state(kAgent);
  for (int i = 0; i < 3; ++i) {
    const Answer answer = ask(subject, kAgent, state);
    if (!answer.status.ok()) return fail(to_text(answer.status));
  }
  return pass("same State sent three times");
}

Finding with_preprocess(PlaymakerSubject& subject) {
  protos::State state = subject.next_state(kAgent);
  state.set_need_preprocess(true);
  const Answer answer = ask(subject, kAgent, state);
  return finding(answer.status, kinds(answer.actions));
}

Finding with_full_world(PlaymakerSubject& subject) {
  protos::State state = subject.next_state(kAgent);
  *state.mutable_full_world_model() = state.world_model();
  const Answer answer = ask(subject, kAgent, state);
  return finding(answer.status, kinds(answer.actions));
}

// RPCs that a Playmaker may leave unimplemented.
bool is_unimplemented(const proxy::Reply& reply) {
  return reply.status.outcome == proxy::RpcOutcome::kUnimplemented;
}

template <typename Actions>
Finding counted(const proxy::Reply& reply) {
  const auto* actions = reply.as<Actions>();
  const int count = actions != nullptr ? actions->actions_size() : 0;
  return finding(reply.status, fmt::format("{} actions", count));
}

Finding coach_actions(PlaymakerSubject& subject) {
  const proxy::Reply reply =
      subject.left().call(proxy::kCoachNumber, Rpc::kGetCoachActions,
                          subject.next_state(proxy::kCoachNumber), subject.deadline);

  if (is_unimplemented(reply)) {
    subject.has_coach = false;
    return skip("not implemented: the team plays without a coach");
  }

  return counted<protos::CoachActions>(reply);
}

Finding trainer_actions(PlaymakerSubject& subject) {
  const proxy::Reply reply =
      subject.left().call(proxy::kTrainerNumber, Rpc::kGetTrainerActions,
                          subject.next_state(proxy::kTrainerNumber), subject.deadline);
  if (is_unimplemented(reply)) return skip("not implemented: no trainer");
  return counted<protos::TrainerActions>(reply);
}

Finding plan(PlaymakerSubject& subject, int candidates) {
  const auto request = planner_request(subject.next_state(kAgent), candidates);
  const proxy::Reply reply =
      subject.left().call(kAgent, Rpc::kGetBestPlannerAction, request, subject.deadline);
  if (is_unimplemented(reply)) return skip("not implemented: the proxy decides itself");

  const auto* choice = reply.as<protos::BestPlannerActionResponse>();
  const int index = choice != nullptr ? choice->index() : 0;
  const std::string evidence = fmt::format("{} candidates ({} bytes), chosen: {}", candidates,
                                           request.ByteSizeLong(), index);

  const Finding found = finding(reply.status, evidence);
  const bool in_range = candidates == 0 || request.pairs().contains(index);
  return found.result == StepResult::kPass && !in_range ? fail(evidence) : found;
}

Finding planner(PlaymakerSubject& subject) { return plan(subject, 5); }
Finding planner_large(PlaymakerSubject& subject) { return plan(subject, 493); }

Finding planner_empty(PlaymakerSubject& subject) {
  const auto request = planner_request(subject.next_state(kAgent), 0);
  const auto status = call(subject, kAgent, Rpc::kGetBestPlannerAction, request);
  return survives(subject, status.ok() ? "no candidates: accepted" : "no candidates: refused");
}

}  // namespace

std::vector<PlaymakerStep> decision_steps() {
  return {
      {"player_actions", "Called for every player in every cycle.", player_actions},
      {"known_actions", "The proxy cannot execute an action that the interface lacks.",
       known_actions},
      {"finite_numbers", "The soccer server ignores commands with NaN.", finite_numbers},
      {"reply_size", "A reply is executed in one cycle; a huge one indicates a runaway loop.",
       reply_size},
      {"same_question", "With a stopped clock, the same cycle is requested repeatedly.",
       same_question},
      {"need_preprocess", "Set in about every second request of upstream's proxy.",
       with_preprocess},
      {"full_world_model", "Sent when the soccer server runs with fullstate.", with_full_world},
      {"coach_actions", "Called for the coach in every cycle.", coach_actions},
      {"trainer_actions", "Called for the trainer in every cycle.", trainer_actions},
      {"planner", "The chosen action must be one of the candidates.", planner},
      {"planner_493_candidates", "What upstream's planner sends in the final third.",
       planner_large},
      {"planner_no_candidates", "A player without options sends an empty list.", planner_empty},
  };
}

}  // namespace cls::checks
