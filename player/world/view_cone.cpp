// View cone geometry and the age of each direction sector.
#include "player/world/view_cone.h"

#include <algorithm>
#include <cmath>

namespace cls::player {
namespace {

/// Calls `visit` for each range [from, to) of sectors around a direction: two ranges where they
/// pass 180 degrees.
template <typename Visit>
void for_sectors_around(AngleDeg direction, double half_width, const Visit& visit) {
  const SectorRange range = sectors_around(direction, half_width);
  const int end = range.first + range.count;
  visit(range.first, std::min(end, ViewMemory::kSectors));
  visit(0, end - ViewMemory::kSectors);
}

}  // namespace

SectorRange sectors_around(AngleDeg direction, double half_width) {
  constexpr int kSectors = ViewMemory::kSectors;
  const double center = (direction.degrees() + 180.0) / ViewMemory::kSectorDegrees - 0.5;
  if (!std::isfinite(center) || std::isnan(half_width)) return {};
  const double reach = std::clamp(half_width, 0.0, 180.0) / ViewMemory::kSectorDegrees;
  const int first = static_cast<int>(std::ceil(center - reach));
  const int end = static_cast<int>(std::floor(center + reach)) + 1;
  return {(first + 2 * kSectors) % kSectors, std::clamp(end - first, 0, kSectors)};
}

int ViewMemory::sector_of(AngleDeg direction) {
  const double sector = std::floor((direction.degrees() + 180.0) / kSectorDegrees);
  if (std::isnan(sector)) return 0;
  return static_cast<int>(std::clamp(sector, 0.0, kSectors - 1.0));
}

int ViewMemory::age_around(AngleDeg direction, double half_width) const {
  int sum = 0;
  for_sectors_around(direction, half_width, [&](int from, int to) {
    for (int sector = from; sector < to; ++sector) sum += ages[sector];
  });
  return sum;
}

void update_view_memory(ViewMemory& view, const WorldModel& world) {
  if (!(view.updated == world.game.time)) {
    for (int& age : view.ages) age = older(age);
    view.updated = world.game.time;
  }

  if (!(world.game.last_see == world.game.time)) return;
  const double half = view_angle(world.server(), world.self.view_width) / 2.0;
  for_sectors_around(world.self.face(), half, [&](int from, int to) {
    for (int sector = from; sector < to; ++sector) view.ages[sector] = 0;
  });
}

double view_angle(const soccer::ServerParams& server, soccer::ViewWidth width) {
  const double share = width == soccer::ViewWidth::kNarrow   ? 2.0 / 3.0
                       : width == soccer::ViewWidth::kNormal ? 4.0 / 3.0
                                                             : 2.0;
  return server.visible_angle * share;
}

bool VisibleArea::must_show(Vec2 position, double deviation) const {
  const Vec2 offset = position - eye_;
  const double distance = offset.length();

  constexpr double kSure = 2.5;  // standard deviations
  const double blur = kSure * deviation;
  if (distance + blur < near_) return true;
  if (distance <= blur) return false;
  // Most objects are outside, and found so without their angle.
  if (soccer::dot(offset, toward_face_) < distance * cosine_) return false;

  const double angle = (AngleDeg::of(offset) - face_).abs();
  const double margin = math::to_degrees(math::asin(blur / distance)) + 1.0;
  return angle + margin < half_angle_;
}

}  // namespace cls::player
