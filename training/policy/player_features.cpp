// Fills a scene of the world model, and the features of it.
#include "training/policy/player_features.h"

#include "soccer/pitch.h"
#include "training/scene/estimated_scene.h"

namespace cls::training {

PlayerFeatures::PlayerFeatures(const FeatureSet& set) : set_(&set) {
  numbers_.resize(set.columns(soccer::kPlayersPerTeam - 1, soccer::kPlayersPerTeam).size());
}

const std::vector<float>& PlayerFeatures::of(const player::WorldModel& world,
                                             const player::OptionTable& table) {
  fill_scene(world, everybody_, scene_);
  const Seat self = seat_of(world.our_side, soccer::slot_of(world.our_side, world.unum));
  PointOfView view{scene_, everybody_, self, {-soccer::kHalfLength, soccer::kHalfLength}};
  view.world = &world;
  view.options = &table;
  set_->fill(view, numbers_.data());
  return numbers_;
}

}  // namespace cls::training
