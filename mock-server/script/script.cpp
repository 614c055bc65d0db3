// Reading scripts and following them.
#include "mock-server/script/script.h"

#include <fmt/format.h>

#include "mock-server/script/message_json.h"
#include "proto/rpc.h"

namespace cls::mock_server {
namespace {

using base::Result;

Result<std::shared_ptr<const Behaviour>> parse_behaviour(const base::JsonValue& json) {
  const auto word = json.string();
  if (!word) return word.error();
  auto behaviour = make_behaviour(*word);
  if (!behaviour) return json.error(behaviour.error().message);
  return std::shared_ptr<const Behaviour>(*std::move(behaviour));
}

// A reply is the reply message, or only its list of actions.
Result<std::shared_ptr<const google::protobuf::Message>> parse_reply(const base::JsonValue& json,
                                                                     proto::Rpc rpc) {
  std::shared_ptr<google::protobuf::Message> reply(reply_prototype(rpc).New());
  if (!json.is_list()) {
    if (const auto read = read_message(json, *reply); !read) return read.error();
    return std::shared_ptr<const google::protobuf::Message>(std::move(reply));
  }
  const auto* descriptor = reply->GetDescriptor()->FindFieldByName("actions");
  for (std::size_t i = 0; i < json.size(); ++i) {
    auto* action = reply->GetReflection()->AddMessage(reply.get(), descriptor);
    if (const auto read = read_message(json[i], *action); !read) return read.error();
  }
  return std::shared_ptr<const google::protobuf::Message>(std::move(reply));
}

Result<ScriptRule> parse_rule(const base::JsonValue& json) {
  if (const auto keys = json.object_of({"rpc", "when", "reply", "note"}); !keys) {
    return keys.error();
  }
  ScriptRule rule;
  if (json.has("rpc")) {
    const auto word =
        json["rpc"].word({"GetPlayerActions", "GetCoachActions", "GetTrainerActions"});
    if (!word) return word.error();
    rule.rpc = *proto::rpc_from_name(*word);
  }
  if (json.has("when")) {
    auto when = SituationFilter::parse(json["when"], rule.rpc);
    if (!when) return when.error();
    rule.when = *std::move(when);
  }
  if (!json.has("reply")) return json.error("needs \"reply\"");
  const base::JsonValue reply = json["reply"];
  if (reply.is_string()) {
    auto behaviour = parse_behaviour(reply);
    if (!behaviour) return behaviour.error();
    rule.behaviour = *std::move(behaviour);
    return rule;
  }
  auto message = parse_reply(reply, rule.rpc);
  if (!message) return message.error();
  rule.reply = *std::move(message);
  return rule;
}

}  // namespace

const std::vector<std::string_view>& script_keys() {
  static const std::vector<std::string_view> keys = {"note", "rules", "otherwise", "expect",
                                                     "faults"};
  return keys;
}

Result<std::shared_ptr<const Script>> parse_script(const base::JsonValue& json) {
  if (const auto keys = json.object_of(script_keys()); !keys) return keys.error();
  auto script = std::make_shared<Script>();
  if (json.has("rules")) {
    const base::JsonValue rules = json["rules"];
    if (!rules.is_list()) return rules.error("must be a list");
    for (std::size_t i = 0; i < rules.size(); ++i) {
      auto rule = parse_rule(rules[i]);
      if (!rule) return rule.error();
      script->rules.push_back(*std::move(rule));
    }
  }
  if (json.has("otherwise")) {
    auto behaviour = parse_behaviour(json["otherwise"]);
    if (!behaviour) return behaviour.error();
    script->otherwise = *std::move(behaviour);
  } else {
    script->otherwise = *make_behaviour("hold");
  }
  if (json.has("expect")) {
    auto expectations = parse_expectations(json["expect"]);
    if (!expectations) return expectations.error();
    script->expectations = *std::move(expectations);
  }
  if (json.has("faults")) {
    auto faults = parse_faults(json["faults"]);
    if (!faults) return faults.error();
    script->faults = *std::move(faults);
  }
  return std::shared_ptr<const Script>(std::move(script));
}

Result<std::shared_ptr<const Script>> read_script(const std::filesystem::path& path) {
  const auto text = base::JsonText::read(path);
  if (!text) return text.error();
  return parse_script(base::JsonValue(*text));
}

const ScriptRule* ScriptedBehaviour::rule_for(proto::Rpc rpc, const protos::State& state) const {
  for (const ScriptRule& rule : script_->rules) {
    if (rule.rpc == rpc && rule.when.matches(rpc, state)) return &rule;
  }
  return nullptr;
}

void ScriptedBehaviour::decide(const protos::State& state, protos::PlayerActions& actions) const {
  const ScriptRule* rule = rule_for(proto::Rpc::kGetPlayerActions, state);
  if (rule == nullptr) {
    script_->otherwise->decide(state, actions);
  } else if (rule->reply != nullptr) {
    actions.CopyFrom(*rule->reply);
  } else {
    rule->behaviour->decide(state, actions);
  }
}

void ScriptedBehaviour::decide_as_coach(const protos::State& state,
                                        protos::CoachActions& actions) const {
  const ScriptRule* rule = rule_for(proto::Rpc::kGetCoachActions, state);
  if (rule == nullptr) {
    script_->otherwise->decide_as_coach(state, actions);
  } else if (rule->reply != nullptr) {
    actions.CopyFrom(*rule->reply);
  } else {
    rule->behaviour->decide_as_coach(state, actions);
  }
}

void ScriptedBehaviour::decide_as_trainer(const protos::State& state,
                                          protos::TrainerActions& actions) const {
  const ScriptRule* rule = rule_for(proto::Rpc::kGetTrainerActions, state);
  if (rule == nullptr) {
    script_->otherwise->decide_as_trainer(state, actions);
  } else if (rule->reply != nullptr) {
    actions.CopyFrom(*rule->reply);
  } else {
    rule->behaviour->decide_as_trainer(state, actions);
  }
}

}  // namespace cls::mock_server
