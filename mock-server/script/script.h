// A mock's script: a JSON file that says what to answer when, what to expect, what to do wrong.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/text/json_text.h"
#include "mock-server/behaviour.h"
#include "mock-server/faults.h"
#include "mock-server/script/expectations.h"
#include "mock-server/script/situation_filter.h"

namespace cls::mock_server {

/// The first rule that matches a request gives the answer: a message, or what a behaviour says.
struct ScriptRule {
  proto::Rpc rpc = proto::Rpc::kGetPlayerActions;
  SituationFilter when;
  std::shared_ptr<const google::protobuf::Message> reply;  ///< null: ask `behaviour`
  std::shared_ptr<const Behaviour> behaviour;
};

/// docs/mock.md describes the format.
struct Script {
  std::vector<ScriptRule> rules;
  std::shared_ptr<const Behaviour> otherwise;  ///< where no rule matches
  std::vector<Expectation> expectations;
  Faults faults;
};

/// Keys a script may have, for documents that hold one among other things.
const std::vector<std::string_view>& script_keys();

/// Errors name file, line and place.
base::Result<std::shared_ptr<const Script>> parse_script(const base::JsonValue& json);
base::Result<std::shared_ptr<const Script>> read_script(const std::filesystem::path& path);

/// Plays a script. Like every behaviour it keeps no memory between calls.
class ScriptedBehaviour : public Behaviour {
 public:
  explicit ScriptedBehaviour(std::shared_ptr<const Script> script) : script_(std::move(script)) {}

  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
  void decide_as_coach(const protos::State& state, protos::CoachActions& actions) const override;
  void decide_as_trainer(const protos::State& state,
                         protos::TrainerActions& actions) const override;

 private:
  const ScriptRule* rule_for(proto::Rpc rpc, const protos::State& state) const;

  std::shared_ptr<const Script> script_;
};

}  // namespace cls::mock_server
