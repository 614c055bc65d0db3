// The view cone: its width, what it must show, and how long ago each direction was in view.
#pragma once

#include <array>

#include "player/world/world_model.h"

namespace cls::player {

/// Cycles since each direction was in view: global directions in 5-degree sectors from -180.
struct ViewMemory {
  static constexpr int kSectors = 72;
  static constexpr double kSectorDegrees = 360.0 / kSectors;
  std::array<int, kSectors> ages;  ///< cycles since the sector was in view
  GameTime updated;

  ViewMemory() { ages.fill(kNever); }

  static int sector_of(AngleDeg direction);
  /// Sum of the ages of the sectors within `half_width` degrees of `direction`.
  int age_around(AngleDeg direction, double half_width) const;
};

/// Neighboring sectors of ViewMemory; the first one follows the last.
struct SectorRange {
  int first = 0;
  int count = 0;
};

/// The sectors whose middle is within `half_width` degrees of `direction`; none where a number is
/// not finite, as after nonsense of a faulty server.
SectorRange sectors_around(AngleDeg direction, double half_width);

/// Call once per decision: increments the ages and resets those in the current view cone.
void update_view_memory(ViewMemory& view, const WorldModel& world);

/// Width of the view cone in degrees in synchronous mode (clients of version 18 and later).
double view_angle(const soccer::ServerParams& server, soccer::ViewWidth width);

/// The area that the current see message must show.
class VisibleArea {
 public:
  explicit VisibleArea(const WorldModel& world) : world_(world) {}

  /// True for an object at `position` with standard deviation `deviation` per axis inside the view
  /// cone or visible_distance, with a margin.
  bool must_show(Vec2 position, double deviation) const;

 private:
  const WorldModel& world_;
  Vec2 eye_ = world_.self.position;
  AngleDeg face_ = world_.self.face();
  Vec2 toward_face_ = soccer::polar(1.0, face_);  ///< unit vector
  /// Of the view cone, degrees.
  double half_angle_ = 0.5 * view_angle(world_.server(), world_.self.view_width);
  /// Of it; below -1 where the cone is everything.
  double cosine_ = half_angle_ < 180.0 ? math::cos(math::to_radians(half_angle_)) : -2.0;
  /// Objects within this distance are seen in all directions.
  double near_ = world_.server().visible_distance - 0.1;
};

}  // namespace cls::player
