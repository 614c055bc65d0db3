// Parsing and executing scripts.
#include "mock-server/script/script.h"

#include <fmt/format.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/util/json_util.h>

#include "base/text/json.h"
#include "mock-server/script/json_parts.h"
#include "mock-server/script/named_behaviors.h"
#include "proto/rpc.h"

namespace cls::mock_server {
namespace {

using base::Result;
using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;

Result<void> check_keys(const base::JsonValue& json, const Descriptor& type);

Result<void> check_element(const base::JsonValue& json, const FieldDescriptor& field) {
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
    return check_keys(json, *field.message_type());
  }
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_ENUM && json.is_string()) {
    TRY(json.one_of(value_names(*field.enum_type())));
  }
  return {};
}

Result<void> check_field(const base::JsonValue& json, const FieldDescriptor& field) {
  if (field.is_map()) {
    if (!json.is_object()) return json.error("must be an object");
    const FieldDescriptor& value = *field.message_type()->map_value();
    for (const std::string& key : json.keys()) TRY(check_element(json[key], value));
    return {};
  }

  if (!field.is_repeated()) return check_element(json, field);
  if (!json.is_array()) return json.error("must be a list");
  for (std::size_t i = 0; i < json.size(); ++i) TRY(check_element(json[i], field));
  return {};
}

Result<void> check_keys(const base::JsonValue& json, const Descriptor& type) {
  if (!json.is_object()) {
    return json.error(fmt::format("must be an object with the fields of {}", type.name()));
  }

  for (const std::string& key : json.keys()) {
    const FieldDescriptor* field = find_field(type, key);
    if (field == nullptr) return json[key].error(no_such_field(type, key));
    TRY(check_field(json[key], *field));
  }
  return {};
}

/// Fills the empty `message` from protobuf's JSON mapping. Keys are checked here, with location and
/// suggestion, values by protobuf.
Result<void> read_message(const base::JsonValue& json, google::protobuf::Message& message) {
  TRY(check_keys(json, *message.GetDescriptor()));
  const auto status = google::protobuf::util::JsonStringToMessage(json.json().dump(), &message);
  if (!status.ok()) return json.error(std::string(status.message()));
  return {};
}

Result<std::shared_ptr<const Behavior>> parse_behavior(const base::JsonValue& json) {
  TRY_INIT(const auto name, json.string());
  auto behavior = make_behavior(name);
  if (!behavior) return json.error(behavior.error().message);
  return std::shared_ptr<const Behavior>(*std::move(behavior));
}

// A reply is the reply message, or only its list of actions.
Result<std::shared_ptr<google::protobuf::Message>> parse_reply(const base::JsonValue& json,
                                                               proto::Rpc rpc) {
  std::shared_ptr<google::protobuf::Message> reply(reply_prototype(rpc).New());
  if (!json.is_array()) {
    TRY(read_message(json, *reply));
    return reply;
  }

  const auto* descriptor = reply->GetDescriptor()->FindFieldByName("actions");
  for (std::size_t i = 0; i < json.size(); ++i) {
    auto* action = reply->GetReflection()->AddMessage(reply.get(), descriptor);
    TRY(read_message(json[i], *action));
  }
  return reply;
}

Result<ScriptRule> parse_rule(const base::JsonValue& json) {
  TRY(json.expect_keys({"rpc", "when", "reply", "note"}));

  ScriptRule rule;
  if (json.has("rpc")) {
    TRY_INIT(const auto name,
             json["rpc"].one_of({"GetPlayerActions", "GetCoachActions", "GetTrainerActions"}));
    rule.rpc = *proto::rpc_from_name(name);
  }

  TRY(read_key(json, "when", rule.when, [&](const base::JsonValue& when) {
    return SituationFilter::parse(when, rule.rpc);
  }));

  if (!json.has("reply")) return json.error("needs \"reply\"");
  const base::JsonValue reply = json["reply"];
  if (reply.is_string()) {
    TRY_INIT(rule.behavior, parse_behavior(reply));
  } else {
    TRY_INIT(rule.reply, parse_reply(reply, rule.rpc));
  }
  return rule;
}

}  // namespace

const std::vector<std::string_view>& script_keys() {
  static const std::vector<std::string_view> keys = {"note", "rules", "otherwise", "expect",
                                                     "faults"};
  return keys;
}

Result<std::shared_ptr<const Script>> parse_script(const base::JsonValue& json) {
  TRY(json.expect_keys(script_keys()));
  auto script = std::make_shared<Script>();

  script->otherwise = *make_behavior("hold");
  TRY(read_key(json, "rules", script->rules,
               [](const base::JsonValue& rules) { return list_of(rules, parse_rule); }));
  TRY(read_key(json, "otherwise", script->otherwise, parse_behavior));
  TRY(read_key(json, "expect", script->expectations, parse_expectations));
  TRY(read_key(json, "faults", script->faults, parse_faults));
  return std::shared_ptr<const Script>(std::move(script));
}

Result<std::shared_ptr<const Script>> read_script(const std::filesystem::path& path) {
  TRY_INIT(const auto text, base::JsonDocument::read(path));
  return parse_script(base::JsonValue(text));
}

const ScriptRule* ScriptedBehavior::rule_for(proto::Rpc rpc, const protos::State& state) const {
  for (const ScriptRule& rule : script_->rules) {
    if (rule.rpc == rpc && rule.when.matches(rpc, state)) return &rule;
  }
  return nullptr;
}

template <typename Actions, typename Decide>
void ScriptedBehavior::execute(proto::Rpc rpc, const protos::State& state, Actions& actions,
                               Decide function) const {
  const ScriptRule* rule = rule_for(rpc, state);
  if (rule != nullptr && rule->reply != nullptr) {
    actions.CopyFrom(*rule->reply);
  } else {
    ((rule == nullptr ? *script_->otherwise : *rule->behavior).*function)(state, actions);
  }
}

void ScriptedBehavior::decide(const protos::State& state, protos::PlayerActions& actions) const {
  execute(proto::Rpc::kGetPlayerActions, state, actions, &Behavior::decide);
}

void ScriptedBehavior::decide_as_coach(const protos::State& state,
                                       protos::CoachActions& actions) const {
  execute(proto::Rpc::kGetCoachActions, state, actions, &Behavior::decide_as_coach);
}

void ScriptedBehavior::decide_as_trainer(const protos::State& state,
                                         protos::TrainerActions& actions) const {
  execute(proto::Rpc::kGetTrainerActions, state, actions, &Behavior::decide_as_trainer);
}

}  // namespace cls::mock_server
