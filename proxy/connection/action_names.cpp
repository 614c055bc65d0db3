// Takes the names from the descriptors of the messages.
#include "proxy/connection/action_names.h"

#include <google/protobuf/descriptor.h>

#include <utility>

#include "base/index.h"
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

// Calls `use` with name and counts of each action and say message.
template <typename Use>
void for_each_action(const player::ActionReport& report, Use use) {
  for (int kind = 0; kind < player::kActionKinds; ++kind) {
    use(std::string(action_name(kind)), report.actions[base::index(kind)]);
  }
  for (int kind = 0; kind < player::kSayKinds; ++kind) {
    use("say." + std::string(say_name(kind)), report.say[base::index(kind)]);
  }
}

}  // namespace

std::string_view action_name(int kind) {
  return member_name(protos::PlayerAction::descriptor(), kind);
}

std::string_view say_name(int kind) { return member_name(protos::Say::descriptor(), kind); }

ActionOutcomes outcomes_by_name(const player::ActionReport& report) {
  ActionOutcomes outcomes;
  for_each_action(report, [&](std::string name, const player::ActionCounts& counts) {
    auto found = by_outcome(counts);
    if (!found.empty()) outcomes.emplace(std::move(name), std::move(found));
  });
  return outcomes;
}

std::map<std::string, std::int64_t> unimplemented_by_name(const player::ActionReport& report) {
  std::map<std::string, std::int64_t> by_name;
  for_each_action(report, [&](const std::string& name, const player::ActionCounts& counts) {
    if (counts.unimplemented != 0) by_name[name] += counts.unimplemented;
  });
  return by_name;
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
