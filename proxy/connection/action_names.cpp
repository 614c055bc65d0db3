// Takes the names from the descriptors of the messages.
#include "proxy/connection/action_names.h"

#include <google/protobuf/descriptor.h>

#include <utility>

#include "proto/playmaker.pb.h"

namespace cls::proxy {
namespace {

std::map<std::string, std::int64_t> by_outcome(const player::ActionCounts& counts) {
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

std::string_view action_name(int kind) {
  return member_name(protos::PlayerAction::descriptor(), kind);
}

std::string_view say_name(int kind) { return member_name(protos::Say::descriptor(), kind); }

ActionOutcomes outcomes_by_name(const player::ActionReport& report) {
  ActionOutcomes outcomes;
  const auto add = [&outcomes](const std::string& name, const player::ActionCounts& counts) {
    if (auto found = by_outcome(counts); !found.empty()) outcomes.emplace(name, std::move(found));
  };
  for (int kind = 0; kind < player::kActionKinds; ++kind) {
    add(std::string(action_name(kind)), report.actions[static_cast<std::size_t>(kind)]);
  }
  for (int kind = 0; kind < player::kSayKinds; ++kind) {
    add("say." + std::string(say_name(kind)), report.say[static_cast<std::size_t>(kind)]);
  }
  return outcomes;
}

std::map<std::string, std::int64_t> automatic_by_name(const player::ActionReport& report) {
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
