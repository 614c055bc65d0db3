// Sums and names of action counts.
#include "proxy/connection/action_report.h"

#include <google/protobuf/descriptor.h>

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
}

std::string_view action_name(int kind) {
  return member_name(protos::PlayerAction::descriptor(), kind);
}

std::string_view say_name(int kind) { return member_name(protos::Say::descriptor(), kind); }

}  // namespace cls::proxy
