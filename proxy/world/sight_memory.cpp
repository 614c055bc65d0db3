// Sectors of sight.
#include "proxy/world/sight_memory.h"

#include <algorithm>
#include <cmath>

namespace cls::proxy {
namespace {

constexpr double kSectorDegrees = 360.0 / SightMemory::kSectors;

/// Calls `visit` with each sector whose middle lies within `half_width` of `direction`.
template <typename Visit>
void for_sectors_around(soccer::AngleDeg direction, double half_width, const Visit& visit) {
  const double centre = (direction.degrees() + 180.0) / kSectorDegrees - 0.5;
  const double reach = std::clamp(half_width, 0.0, 180.0) / kSectorDegrees;
  const int first = static_cast<int>(std::ceil(centre - reach));
  const int last =
      std::min(static_cast<int>(std::floor(centre + reach)), first + SightMemory::kSectors - 1);
  for (int sector = first; sector <= last; ++sector) {
    visit((sector + SightMemory::kSectors) % SightMemory::kSectors);
  }
}

}  // namespace

int SightMemory::sector_of(soccer::AngleDeg direction) {
  const int sector = static_cast<int>(std::floor((direction.degrees() + 180.0) / kSectorDegrees));
  return std::clamp(sector, 0, kSectors - 1);
}

int SightMemory::age_around(soccer::AngleDeg direction, double half_width) const {
  int sum = 0;
  for_sectors_around(direction, half_width, [&](int sector) { sum += ages[sector]; });
  return sum;
}

void note_sight(SightMemory& sight, const WorldModel& world) {
  if (!(sight.updated == world.game.time)) {
    for (int& age : sight.ages) age = older(age);
    sight.updated = world.game.time;
  }
  if (!(world.game.last_see == world.game.time)) return;
  const double half = view_angle(world.server(), world.self.view_width) / 2.0;
  for_sectors_around(world.self.face(), half, [&](int sector) { sight.ages[sector] = 0; });
}

double view_angle(const soccer::ServerParams& server, soccer::ViewWidth width) {
  const double share = width == soccer::ViewWidth::kNarrow   ? 2.0 / 3.0
                       : width == soccer::ViewWidth::kNormal ? 4.0 / 3.0
                                                             : 2.0;
  return server.visible_angle * share;
}

}  // namespace cls::proxy
