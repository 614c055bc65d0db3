// Facts and geometry of a State. Only + - * / and sqrt, in the order of examples/TEAM.md, so that
// every language computes the same bits.
#include "mock-server/behavior/example_situation.h"

#include <algorithm>

#include "base/index.h"

namespace cls::mock_server::example {
namespace {

constexpr int kMaxAge = 20;  // cycles; older estimates of opponents are ignored

// A player id of 0 means that no such player is known.
int steps(bool kickable, int player_id, int cycles) {
  if (kickable) return 0;
  return player_id == 0 ? static_cast<int>(kFar) : cycles;
}

}  // namespace

soccer::Vec2 point_of(const protos::RpcVector2D& vector) { return {vector.x(), vector.y()}; }

Situation situation_of(const protos::WorldModel& world) {
  const protos::InterceptTable& table = world.intercept_table();
  Situation now;
  now.world = &world;
  now.self = &world.self();
  now.me = point_of(world.self().position());
  now.ball = point_of(world.ball().position());

  now.my_steps = world.self().is_kickable() ? 0 : table.self_reach_steps();
  now.our_steps = steps(world.kickable_teammate_existance(), table.first_teammate_id(),
                        table.first_teammate_reach_steps());
  now.their_steps = steps(world.kickable_opponent_existance(), table.first_opponent_id(),
                          table.first_opponent_reach_steps());

  now.opponents.reserve(base::index(world.opponents_size()));
  for (const protos::Player& player : world.opponents()) {
    if (player.pos_count() <= kMaxAge) now.opponents.push_back(point_of(player.position()));
  }

  return now;
}

double room(const Situation& now, soccer::Vec2 place) {
  double nearest = kFar;
  for (const soccer::Vec2& opponent : now.opponents) {
    nearest = std::min(nearest, distance(opponent, place));
  }
  return nearest;
}

double lane(const Situation& now, soccer::Vec2 start, soccer::Vec2 end) {
  const soccer::Vec2 way = end - start;
  const double whole = way.length();
  if (whole < 0.1) return kFar;

  double free = kFar;
  for (const soccer::Vec2& opponent : now.opponents) {
    double along = dot(opponent - start, way) / whole;
    if (along < 0) continue;

    along = std::min(along, whole);
    const soccer::Vec2 passed = start + way * (along / whole);
    free = std::min(free, distance(opponent, passed) - 0.8 - 0.2 * along);
  }
  return free;
}

}  // namespace cls::mock_server::example
