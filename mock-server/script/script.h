// A mock's script: a JSON file with rules for replies, expectations and faults.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "base/result.h"
#include "base/text/json_document.h"
#include "mock-server/behavior/behavior.h"
#include "mock-server/script/expectations.h"
#include "mock-server/script/faults.h"
#include "mock-server/script/situation_filter.h"

namespace cls::mock_server {

/// The first rule that matches a request determines the reply: a message, or a behavior.
struct ScriptRule {
  proto::Rpc rpc = proto::Rpc::kGetPlayerActions;
  SituationFilter when;
  std::shared_ptr<const google::protobuf::Message> reply;  ///< null: use `behavior`
  std::shared_ptr<const Behavior> behavior;
};

/// docs/mock.md describes the format.
struct Script {
  std::vector<ScriptRule> rules;
  std::shared_ptr<const Behavior> otherwise;  ///< where no rule matches
  std::vector<Expectation> expectations;
  Faults faults;
};

/// Keys of a script, for documents that contain one and other keys.
const std::vector<std::string_view>& script_keys();

/// Errors name file, line and JSON path.
base::Result<std::shared_ptr<const Script>> parse_script(const base::JsonValue& json);
base::Result<std::shared_ptr<const Script>> read_script(const std::filesystem::path& path);

/// Executes a script. Like every behavior it stores nothing between calls.
class ScriptedBehavior : public Behavior {
 public:
  explicit ScriptedBehavior(std::shared_ptr<const Script> script) : script_(std::move(script)) {}

  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
  void decide_as_coach(const protos::State& state, protos::CoachActions& actions) const override;
  void decide_as_trainer(const protos::State& state,
                         protos::TrainerActions& actions) const override;

 private:
  template <typename Actions, typename Decide>
  void execute(proto::Rpc rpc, const protos::State& state, Actions& actions, Decide function) const;
  const ScriptRule* rule_for(proto::Rpc rpc, const protos::State& state) const;

  std::shared_ptr<const Script> script_;
};

}  // namespace cls::mock_server
