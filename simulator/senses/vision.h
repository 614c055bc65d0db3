// Visual sensor of a player: builds see messages.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/world/world.h"
#include "soccer/messages/see.h"

namespace cls::simulator {

/// Quantizes distances to exp of a multiple of `step` (docs/spec/simulation-model.md 7.4). A lookup
/// table replaces log and exp for common distances, with the same results.
class DistanceQuantizer {
 public:
  /// A step below 1e-10 means exact distances.
  explicit DistanceQuantizer(double step);

  double operator()(double distance) const;

 private:
  void make_table();
  const double* look_up(double distance) const;

  double step_;
  int first_ = 0;  ///< multiple of step_ of values_[0]
  std::vector<double> values_;

  // values_[i] is the result between edges_[i] and edges_[i + 1]; begins_ maps the leading bits of
  // a distance to the first candidate edge.
  std::vector<double> edges_;
  std::vector<std::uint32_t> begins_;
  std::uint64_t first_bits_ = 0;  ///< leading bits of begins_[0]
};

/// Constants of a match, built once from the parameters.
struct VisionModel {
  explicit VisionModel(const soccer::ServerParams& params)
      : objects(params.quantize_step), landmarks(params.quantize_step_l) {}

  DistanceQuantizer objects;  ///< ball and players
  DistanceQuantizer landmarks;
};

/// Rounds of the view (docs/spec/simulation-model.md 7.2) between two see messages.
int view_interval(const View& view);

/// Fills `out` with the see message of the enabled player in `slot`, for its client version (8 to
/// 19), view width, quality and noise model. `noise` decides which details beyond 20 m are missing
/// and draws the noise of the Gaussian model and of pointing arms.
void see(const VisionModel& model, const World& world, Slot slot, RandomStream& noise,
         soccer::See& out);

}  // namespace cls::simulator
