// Openings from the intervals that opponents cover.
#include "training/scene/openings.h"

#include <algorithm>
#include <limits>

#include "soccer/directions.h"
#include "soccer/math.h"

namespace cls::training {
namespace {

namespace math = soccer::math;

constexpr double kKickableArea = 1.085;  // of player type 0
constexpr std::size_t kMaxPlayers = soccer::kPlayersPerTeam;

/// The part of an eye's view that an opponent covers.
struct Cover {
  double low;
  double high;
  double distance;  ///< meters
};

using Covers = base::FixedList<Cover, kMaxPlayers>;  ///< by low

struct Interval {
  double low;
  double high;
};

/// Vectors from an eye, whose directions are asked for together.
struct Rays {
  std::array<Vec2, 3 * kMaxPlayers + 2> vectors;
  std::array<double, 3 * kMaxPlayers + 2> directions;
  std::size_t count = 0;

  /// Index of the vector.
  std::size_t add(Vec2 vector) {
    vectors[count] = vector;
    return count++;
  }
  void measure() { soccer::directions_radians(vectors.data(), count, directions.data()); }
};

/// Widest part of `whole` that no opponent nearer than `reach` covers.
double widest(const Covers& covers, Interval whole, double reach) {
  double widest = 0.0;
  double free_from = whole.low;
  for (const Cover& cover : covers) {
    if (cover.distance >= reach || cover.high < whole.low || cover.low > whole.high) continue;
    widest = std::max(widest, cover.low - free_from);
    free_from = std::max(free_from, cover.high);
  }
  return std::max(widest, whole.high - free_from);
}

/// Adds two rays for each seen opponent: to it, and the half of its width at its distance.
std::size_t add_opponents(const Scene& scene, const Seats& opponents, Vec2 eye, Rays& rays) {
  std::size_t count = 0;
  for (const Seat seat : opponents) {
    const ScenePlayer& player = scene.player(seat);
    if (!player.seen) continue;
    const Vec2 to = player.position - eye;
    rays.add(to);
    rays.add({to.length(), kKickableArea * 0.5});
    ++count;
  }
  return count;
}

double distance_to_nearest_opponent(const Scene& scene, Vec2 place) {
  const Seat nearest = nearest_player(scene, true, place);
  if (nearest == kNoSeat) return std::numeric_limits<double>::infinity();
  return distance(scene.player(nearest).position, place);
}

Covers covers_of(const Rays& rays, std::size_t opponents) {
  Covers covers;
  for (std::size_t i = 0; i < opponents; ++i) {
    const double middle = rays.directions[2 * i];
    const double half = rays.directions[2 * i + 1];
    covers.push_back({middle - half, middle + half, rays.vectors[2 * i + 1].x});
  }
  std::ranges::sort(covers, {}, &Cover::low);
  return covers;
}

}  // namespace

Openings::Openings(const Scene& scene, const Cast& cast) {
  const Seats team = seats_of(scene.side, cast.team(scene.side));
  const Seats opponents = seats_of(scene.side, cast.others(scene.side));
  const double post = scene.server->goal_width / 2.0;

  for (const Seat seat : team) {
    const Vec2 place = scene.player(seat).position;
    Rays rays;
    const std::size_t seen = add_opponents(scene, opponents, place, rays);
    const std::size_t posts = rays.add(Vec2{soccer::kHalfLength, -post} - place);
    rays.add(Vec2{soccer::kHalfLength, post} - place);
    const std::size_t mates = rays.count;
    for (const Seat mate : team) rays.add(scene.player(mate).position - place);
    rays.measure();

    Eye& eye = eyes_[static_cast<std::size_t>(seat)];
    eye.nearest_opponent = distance_to_nearest_opponent(scene, place);
    const Covers covers = covers_of(rays, seen);
    eye.goal = widest(covers, {rays.directions[posts], rays.directions[posts + 1]},
                      std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < team.size(); ++i) {
      const double middle = rays.directions[mates + i];
      eye.teammates[static_cast<std::size_t>(team[i])] =
          widest(covers, {middle - math::kPi / 4.0, middle + math::kPi / 4.0},
                 rays.vectors[mates + i].length());
    }
  }
}

}  // namespace cls::training
