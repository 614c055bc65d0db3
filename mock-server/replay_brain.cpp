// Recorded replies by moment.
#include "mock-server/replay_brain.h"

#include <utility>

#include "proto/recording_file.h"
#include "proto/rpc.h"

namespace cls::mock_server {

using base::Error;

ReplayBrain::Moment ReplayBrain::moment_of(const protos::State& state) {
  const protos::WorldModel& world = state.world_model();
  return {static_cast<int>(world.our_side()), state.register_response().uniform_number(),
          world.cycle(), world.time_stopped()};
}

base::Result<std::unique_ptr<Behaviour>> ReplayBrain::read(const std::string& path) {
  std::string error;
  const auto reader = proto::RecordingReader::open(path, error);
  if (reader == nullptr) return Error{error};
  auto brain = std::make_unique<ReplayBrain>();
  recording::RecordedCall call;
  while (reader->next(call)) {
    const auto rpc = proto::rpc_from_name(call.rpc());
    if (!rpc || !is_decision(*rpc) || call.status() != 0) continue;
    protos::State state;
    if (!state.ParseFromString(call.request())) continue;
    brain->replies_[moment_of(state)] = call.reply();
  }
  if (!reader->damage().empty()) return Error{reader->damage()};
  return std::unique_ptr<Behaviour>(std::move(brain));
}

void ReplayBrain::repeat(const protos::State& state, google::protobuf::Message& actions) const {
  const auto found = replies_.find(moment_of(state));
  if (found != replies_.end()) actions.ParseFromString(found->second);
}

void ReplayBrain::decide(const protos::State& state, protos::PlayerActions& actions) const {
  repeat(state, actions);
}

void ReplayBrain::decide_as_coach(const protos::State& state, protos::CoachActions& actions) const {
  repeat(state, actions);
}

void ReplayBrain::decide_as_trainer(const protos::State& state,
                                    protos::TrainerActions& actions) const {
  repeat(state, actions);
}

}  // namespace cls::mock_server
