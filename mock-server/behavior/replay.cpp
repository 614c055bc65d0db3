// Repeats the replies of a recording (cls match --record-rpc).
#include <compare>
#include <map>
#include <utility>

#include "mock-server/behavior/bundled.h"
#include "proto/recording_file.h"
#include "proto/rpc.h"

namespace cls::mock_server {
namespace {

using base::Error;

struct DecisionKey {
  int side = 0;
  int unum = 0;
  int cycle = 0;
  int stopped = 0;
  auto operator<=>(const DecisionKey&) const = default;
};

DecisionKey key_of(const protos::State& state) {
  const protos::WorldModel& world = state.world_model();
  return {static_cast<int>(world.our_side()), state.register_response().uniform_number(),
          world.cycle(), world.time_stopped()};
}

class ReplayBehavior : public Behavior {
 public:
  void add(const protos::State& state, std::string reply) {
    replies_[key_of(state)] = std::move(reply);
  }

  void decide(const protos::State& state, protos::PlayerActions& actions) const override {
    repeat(state, actions);
  }
  void decide_as_coach(const protos::State& state, protos::CoachActions& actions) const override {
    repeat(state, actions);
  }
  void decide_as_trainer(const protos::State& state,
                         protos::TrainerActions& actions) const override {
    repeat(state, actions);
  }

 private:
  void repeat(const protos::State& state, google::protobuf::Message& actions) const {
    const auto found = replies_.find(key_of(state));
    if (found != replies_.end()) actions.ParseFromString(found->second);
  }

  std::map<DecisionKey, std::string> replies_;  // serialized
};

}  // namespace

base::Result<std::unique_ptr<Behavior>> read_replay_behavior(const std::string& path) {
  std::string error;
  const auto reader = proto::RecordingReader::open(path, error);
  if (reader == nullptr) return Error{error};

  auto behavior = std::make_unique<ReplayBehavior>();
  recording::RecordedCall call;
  while (reader->next(call)) {
    const auto rpc = proto::rpc_from_name(call.rpc());
    if (!rpc || !is_decision(*rpc) || call.status() != 0) continue;
    protos::State state;
    if (!state.ParseFromString(call.request())) continue;
    behavior->add(state, call.reply());
  }

  if (!reader->parse_error().empty()) return Error{reader->parse_error()};
  return std::unique_ptr<Behavior>(std::move(behavior));
}

}  // namespace cls::mock_server
