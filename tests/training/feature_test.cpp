// Feature sets: sizes, bounds, symmetry.
#include "training/features/feature_set.h"

#include <gtest/gtest.h>

#include "tests/training/stage.h"

namespace cls::tests {
namespace {

TEST(TrainingFeatures, HfoSetsHaveHfosSizes) {
  for (int t = 0; t <= 4; ++t) {
    for (int o = 0; o <= 5; ++o) {
      EXPECT_EQ(training::kHfoLowFeatures.columns(t, o).size(),
                static_cast<std::size_t>(59 + 9 * t + 9 * o));
      EXPECT_EQ(training::kHfoHighFeatures.columns(t, o).size(),
                static_cast<std::size_t>(12 + 6 * t + 3 * o));
    }
  }
}

TEST(TrainingFeatures, NamesAreUnique) {
  for (const training::FeatureSet* set : training::feature_sets()) {
    std::set<std::string> names;
    for (const training::Column& column : set->columns(3, 4)) {
      EXPECT_TRUE(names.insert(column.name).second) << set->name << ": " << column.name;
    }
  }
}

// Position and body of the agent, ball and opponents are mirrored for the right team: a world that
// is rotated by 180 degrees looks the same from the other side.
TEST(TrainingFeatures, TeamsSeeMirroredWorldsAlike) {
  const auto setup = setup_of(
      R"({"task": "Match", "offense": 2, "defense": 2, "agents": "both", "features": "ego"})");
  simulator::World world = setup->prepared;
  for (const int slot : setup->cast.left) {
    const int twin = slot + soccer::kPlayersPerTeam;
    simulator::Player& left = world.player(slot);
    simulator::Player& right = world.player(twin);
    left.position = {10.0 + slot, 5.0};
    left.velocity = {0.3, 0.1};
    left.body = 0.5 + slot;
    right.position = -left.position;
    right.velocity = -left.velocity;
    right.body = soccer::math::normalize_radians(left.body + soccer::math::kPi);
    right.goalie = left.goalie;
  }
  std::array<training::Scene, 2> scenes;
  std::array<std::vector<float>, 2> seen;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const soccer::Side side = i == 0 ? soccer::Side::kLeft : soccer::Side::kRight;
    training::fill_scene(world, side, scenes[i]);
    seen[i].resize(setup->feature_count());
    training::kEgoFeatures.fill({scenes[i], setup->cast, 0, setup->task->stage(side)},
                                seen[i].data());
  }
  for (std::size_t i = 0; i < seen[0].size(); ++i) {
    EXPECT_NEAR(seen[0][i], seen[1][i], 1e-6) << setup->feature_columns[i].name;
  }
}

TEST(TrainingFeatures, AttackersOnlySetIsRefusedForDefenders) {
  EXPECT_THROW(setup_of(R"({"task": "HalfFieldDefense", "features": "hfo_low"})"),
               std::runtime_error);
}

}  // namespace
}  // namespace cls::tests
