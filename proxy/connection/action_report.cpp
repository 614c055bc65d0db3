// Sums and names of action counts.
#include "proxy/connection/action_report.h"

#include <google/protobuf/descriptor.h>

#include <utility>

#include "proto/playmaker.pb.h"

namespace cls::proxy {
namespace {

void add(ActionCounts& into, const ActionCounts& from) {
  into.done += from.done;
  into.failed += from.failed;
  into.skipped += from.skipped;
  into.invalid += from.invalid;
  into.unimplemented += from.unimplemented;
}

std::map<std::string, std::int64_t> by_outcome(const ActionCounts& counts) {
  std::map<std::string, std::int64_t> outcomes;
  for (const auto& [name, count] : {std::pair{"executed", counts.done},
                                    {"failed", counts.failed},
                                    {"skipped", counts.skipped},
                                    {"invalid", counts.invalid},
                                    {"unimplemented", counts.unimplemented}}) {
    if (count != 0) outcomes.emplace(name, count);
  }
  return outcomes;
}

std::string_view member_name(const google::protobuf::Descriptor* message, int number) {
  const google::protobuf::FieldDescriptor* field = message->FindFieldByNumber(number);
  return field != nullptr ? std::string_view(field->name()) : std::string_view("unknown");
}

}  // namespace

void add(ActionReport& into, const ActionReport& from) {
  for (std::size_t i = 0; i < into.actions.size(); ++i) add(into.actions[i], from.actions[i]);
  for (std::size_t i = 0; i < into.say.size(); ++i) add(into.say[i], from.say[i]);
  into.preprocess += from.preprocess;
  into.sure_shot += from.sure_shot;
  into.intention += from.intention;
  into.force_kick += from.force_kick;
  into.heard_pass += from.heard_pass;
  into.lists += from.lists;
  into.empty += from.empty;
  into.useless += from.useless;
}

std::string_view action_name(int kind) {
  return member_name(protos::PlayerAction::descriptor(), kind);
}

std::string_view say_name(int kind) { return member_name(protos::Say::descriptor(), kind); }

ActionOutcomes outcomes_by_name(const ActionReport& report) {
  ActionOutcomes outcomes;
  const auto add = [&outcomes](const std::string& name, const ActionCounts& counts) {
    if (auto found = by_outcome(counts); !found.empty()) outcomes.emplace(name, std::move(found));
  };
  for (int kind = 0; kind < kActionKinds; ++kind) {
    add(std::string(action_name(kind)), report.actions[static_cast<std::size_t>(kind)]);
  }
  for (int kind = 0; kind < kSayKinds; ++kind) {
    add("say." + std::string(say_name(kind)), report.say[static_cast<std::size_t>(kind)]);
  }
  return outcomes;
}

std::map<std::string, std::int64_t> automatic_by_name(const ActionReport& report) {
  std::map<std::string, std::int64_t> by_name;
  for (const auto& [name, count] : {std::pair{"preprocess", report.preprocess},
                                    {"sure_shot", report.sure_shot},
                                    {"intention", report.intention},
                                    {"force_kick", report.force_kick},
                                    {"heard_pass", report.heard_pass}}) {
    if (count != 0) by_name.emplace(name, count);
  }
  return by_name;
}

}  // namespace cls::proxy
