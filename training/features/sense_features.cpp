// Neck, view and focus; the last symbol that was heard.
#include "training/features/sense_features.h"

#include <string>

#include "training/features/feature_writer.h"

namespace cls::training {
namespace {

constexpr double kFocusRange = 40.0;       // m
constexpr double kFocusDirections = 90.0;  // degrees
constexpr double kOldMessage = 30.0;       // cycles, as the ages of estimates

void add_view(const player::SelfState& self, FeatureWriter& out) {
  out.angle(soccer::math::to_radians(self.neck.degrees()));
  for (const soccer::ViewWidth width :
       {soccer::ViewWidth::kNarrow, soccer::ViewWidth::kNormal, soccer::ViewWidth::kWide}) {
    out.flag(self.view_width == width);
  }
  out.value(self.focus_distance / kFocusRange, 0.0);
  out.value(self.focus_direction.degrees() / kFocusDirections);
}

void add_heard(const player::WorldModel& world, const HeardSymbol& heard, FeatureWriter& out) {
  for (int symbol = 1; symbol <= kSymbols; ++symbol) out.flag(heard.symbol == symbol);
  if (heard.symbol == 0) {
    out.same(3, 0.0F);
    out.same(1, 1.0F);
    return;
  }

  const soccer::AngleDeg relative = heard.direction - world.self.body;
  out.angle(soccer::math::to_radians(relative.degrees()));
  out.value(static_cast<double>(heard.unum) / soccer::kPlayersPerTeam, 0.0);
  out.value(heard.age / kOldMessage, 0.0);
}

}  // namespace

Columns sense_columns(const SenseOptions& options) {
  Columns columns;
  if (options.look) {
    append(columns, "own_", {"neck_sin", "neck_cos"});
    append(columns, "own_", {"view_narrow", "view_normal", "view_wide"}, "0/1");
    append(columns, "own_", {"focus_distance"}, "1", 0.0F);
    append(columns, "own_", {"focus_direction"});
  }

  if (options.say) {
    for (int symbol = 0; symbol < kSymbols; ++symbol) {
      append(columns, "heard_" + std::string(1, static_cast<char>('A' + symbol)), {""}, "0/1");
    }
    append(columns, "heard_", {"direction_sin", "direction_cos"});
    append(columns, "heard_", {"number", "age"}, "1", 0.0F);
  }
  return columns;
}

void fill_senses(const Perceiver& agent, const SenseOptions& options, float* out) {
  FeatureWriter writer(out);
  if (options.look) add_view(agent.world.self, writer);
  if (options.say) add_heard(agent.world, agent.heard, writer);
}

}  // namespace cls::training
