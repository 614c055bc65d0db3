// What a player sees: the world turned into a see message.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/world/world.h"
#include "soccer/messages/see.h"

namespace cls::simulator {

/// Distances as eyes tell them apart: exp of a multiple of `step` (simulation model 7.4). Looks
/// common distances up instead of calling log and exp for each; the values are the same.
class DistanceSteps {
 public:
  /// A step below 1e-10 means exact distances.
  explicit DistanceSteps(double step);

  double operator()(double distance) const;

 private:
  void make_table();
  const double* look_up(double distance) const;

  double step_;
  int first_ = 0;  ///< multiple of step_ that values_ begins with
  std::vector<double> values_;

  // values_[i] is told between edges_[i] and edges_[i + 1]; begins_ tells where to look for a
  // distance by its first bits.
  std::vector<double> edges_;
  std::vector<std::uint32_t> begins_;
  std::uint64_t first_bits_ = 0;  ///< of begins_
};

/// What does not change during a match; made once from the parameters.
struct VisionModel {
  explicit VisionModel(const soccer::ServerParams& params)
      : things(params.quantize_step), landmarks(params.quantize_step_l) {}

  DistanceSteps things;  ///< ball and players
  DistanceSteps landmarks;
};

/// Fills `out` with what the enabled player in `observer` sees now, in the form of its client's
/// version (8 to 19), view width, quality and noise model. `noise` decides what is missed beyond
/// 20 m and draws the errors of the Gaussian model and of pointing arms.
void see(const VisionModel& model, const World& world, Slot observer, RandomStream& noise,
         soccer::See& out);

}  // namespace cls::simulator
