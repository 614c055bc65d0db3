// The example team of examples/TEAM.md as a behavior of a mock Playmaker.
#pragma once

#include "mock-server/behavior/behavior.h"

namespace cls::mock_server {

/// Attacks with passes, dribbles and shots, and leaves stopped plays, marking and the goal to the
/// proxy's behaviors. With Defense::kAllMark its replies equal those of the example team in every
/// other language.
class ExampleTeam : public Behavior {
 public:
  /// Who marks, blocks and tackles when opponents have the ball, in addition to the first player
  /// at the ball: all, as the proxy's defense wants, or one center back, while the others keep
  /// their shape. Two teams of the first kind hardly let each other shoot; of the second kind they
  /// score.
  enum class Defense { kAllMark, kOneMarks };

  explicit ExampleTeam(Defense defense) : defense_(defense) {}

  void decide(const protos::State& state, protos::PlayerActions& actions) const override;
  void decide_as_coach(const protos::State& state, protos::CoachActions& actions) const override;

 private:
  Defense defense_;
};

}  // namespace cls::mock_server
