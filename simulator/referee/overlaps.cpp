// Compares players with circles, two at a time.
#include "simulator/referee/overlaps.h"

#include <algorithm>
#include <bit>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace cls::simulator {
namespace {

BodySet only(std::size_t i) { return BodySet{1} << i; }
BodySet all_below(std::size_t i) { return only(i) - 1; }

// Of bodies `first` (even) and above, in any case.
BodySet overlapping_from(std::size_t first, const Bodies& bodies, Vec2 center, double radius) {
  BodySet found = 0;
#ifdef __SSE2__
  const __m128d x = _mm_set1_pd(center.x);
  const __m128d y = _mm_set1_pd(center.y);
  const __m128d own = _mm_set1_pd(radius);

  for (std::size_t i = first; i < bodies.count; i += 2) {
    const __m128d dx = _mm_sub_pd(x, _mm_load_pd(&bodies.x[i]));
    const __m128d dy = _mm_sub_pd(y, _mm_load_pd(&bodies.y[i]));
    const __m128d squared = _mm_add_pd(_mm_mul_pd(dx, dx), _mm_mul_pd(dy, dy));
    const __m128d radii = _mm_add_pd(own, _mm_load_pd(&bodies.size[i]));
    const int both = _mm_movemask_pd(_mm_cmplt_pd(squared, _mm_mul_pd(radii, radii)));
    found |= static_cast<BodySet>(both) << i;
  }
#else
  for (std::size_t i = first; i < bodies.count; ++i) {
    const double radii = radius + bodies.size[i];
    if (squared_distance(center, bodies.position(i)) < radii * radii) found |= only(i);
  }
#endif
  return found & all_below(bodies.count);  // the last pair may be half of one
}

}  // namespace

void refresh(Bodies& bodies, const World& world) {
  const std::size_t before = bodies.count;
  std::size_t i = 0;
  for (std::size_t slot = 0; slot < world.players.size(); ++slot) {
    const Player& player = world.players[slot];
    if (!player.enabled) continue;

    const auto own = static_cast<Slot>(slot);
    const double size = world.type_of(player).player_size;
    const bool changed =
        player.position != bodies.position(i) || size != bodies.size[i] || bodies.slots[i] != own;
    bodies.suspects |= BodySet{changed} << i;

    bodies.x[i] = player.position.x;
    bodies.y[i] = player.position.y;
    bodies.size[i] = size;
    bodies.slots[i] = own;
    bodies.by_slot[slot] = i;
    ++i;
  }
  bodies.count = i;
  if (before != i) bodies.suspects = all_below(i);
}

void move_body(Bodies& bodies, Slot slot, Vec2 position) {
  const std::size_t i = bodies.by_slot[static_cast<std::size_t>(slot)];
  if (i >= bodies.count || bodies.slots[i] != slot) return;  // was sent off
  if (position != bodies.position(i)) bodies.suspects |= only(i);
  bodies.x[i] = position.x;
  bodies.y[i] = position.y;
}

BodySet overlapping(const Bodies& bodies, Vec2 center, double radius) {
  return overlapping_from(0, bodies, center, radius);
}

Overlaps find_overlaps(Bodies& bodies) {
  Overlaps pairs = {};
  BodySet all = 0;
  const auto first_innocent = static_cast<std::size_t>(std::countr_one(bodies.suspects));
  for (BodySet rest = bodies.suspects; rest != 0; rest &= rest - 1) {
    const auto own = static_cast<std::size_t>(std::countr_zero(rest));
    // Pairs with a lower suspect have been found from there.
    const std::size_t first = std::min(own, first_innocent) & ~std::size_t{1};
    const BodySet found =
        overlapping_from(first, bodies, bodies.position(own), bodies.size[own]) & ~only(own);
    if (found == 0) continue;

    all |= found | only(own);
    pairs[own] |= found & ~all_below(own);
    for (BodySet lower = found & all_below(own); lower != 0; lower &= lower - 1) {
      pairs[static_cast<std::size_t>(std::countr_zero(lower))] |= only(own);
    }
  }
  bodies.suspects = all;
  return pairs;
}

}  // namespace cls::simulator
