// A brain that says again what a Playmaker once said.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "base/result.h"
#include "mock-server/behaviour.h"

namespace cls::mock_server {

/// Answers with the recorded reply of the same side, number, cycle and stoppage; with nothing to do
/// where the recording has none.
class ReplayBrain : public Behaviour {
 public:
  /// Reads the replies of both sides. The error names the file.
  static base::Result<std::unique_ptr<Behaviour>> read(const std::string& path);

  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
  void decide_as_coach(const protos::State& state, protos::CoachActions& actions) const override;
  void decide_as_trainer(const protos::State& state,
                         protos::TrainerActions& actions) const override;

 private:
  struct Moment {
    int side = 0;
    int unum = 0;
    int cycle = 0;
    int stoppage = 0;
    auto operator<=>(const Moment&) const = default;
  };
  static Moment moment_of(const protos::State& state);
  void repeat(const protos::State& state, google::protobuf::Message& actions) const;

  std::map<Moment, std::string> replies_;
};

}  // namespace cls::mock_server
