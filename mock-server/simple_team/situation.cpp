// Derived values of a State.
#include "mock-server/simple_team/situation.h"

#include <algorithm>

namespace cls::mock_server {
namespace {

constexpr double kFar = 1000.0;  // no opponent known

// Player id 0 in the intercept table: no player.
int reach(int steps, int player_id) { return player_id == 0 ? kNeverReached : steps; }

// Calls `use` with the position of each opponent that was seen lately.
template <typename Use>
void for_each_opponent(const protos::WorldModel& world, const Use& use) {
  constexpr int kLately = 20;
  for (const protos::Player& player : world.opponents()) {
    if (player.pos_count() <= kLately) use(point_of(player.position()));
  }
}

}  // namespace

soccer::Vec2 point_of(const protos::RpcVector2D& vector) { return {vector.x(), vector.y()}; }

Situation::Situation(const protos::State& state)
    : world_(state.world_model()),
      self_position_(point_of(world_.self().position())),
      ball_(point_of(world_.ball().position())),
      ball_velocity_(point_of(world_.ball().velocity())) {}

int Situation::own_reach() const {
  const int steps = world_.intercept_table().self_reach_steps();
  return can_kick() ? 0 : steps;
}

int Situation::teammates_reach() const {
  if (teammate_has_ball()) return 0;
  const protos::InterceptTable& table = world_.intercept_table();
  return reach(table.first_teammate_reach_steps(), table.first_teammate_id());
}

int Situation::opponents_reach() const {
  if (opponent_has_ball()) return 0;
  const protos::InterceptTable& table = world_.intercept_table();
  return reach(table.first_opponent_reach_steps(), table.first_opponent_id());
}

double Situation::nearest_opponent_to(soccer::Vec2 point) const {
  double nearest = kFar;
  for_each_opponent(world_, [&](soccer::Vec2 opponent) {
    nearest = std::min(nearest, distance(point, opponent));
  });
  return nearest;
}

double Situation::lane_margin(soccer::Vec2 from, soccer::Vec2 to, double base,
                              double spread) const {
  const soccer::Vec2 way = to - from;
  const double length = std::max(way.length(), 0.1);
  double margin = kFar;
  for_each_opponent(world_, [&](soccer::Vec2 opponent) {
    const soccer::Vec2 relative = opponent - from;
    const double along = dot(relative, way) / length;
    if (along < 0.0) return;
    const double passed = std::min(along, length);
    const double beside = distance(opponent, from + way * (passed / length));
    margin = std::min(margin, beside - base - spread * passed);
  });
  return margin;
}

bool Situation::is_nearest_to_ball() const {
  const double own = distance(self_position_, ball_);
  for (const protos::Player& teammate : world_.teammates()) {
    if (teammate.is_goalie() || teammate.pos_count() > 20) continue;
    const double theirs = distance(point_of(teammate.position()), ball_);
    if (theirs < own || (theirs == own && teammate.uniform_number() < unum())) return false;
  }
  return true;
}

}  // namespace cls::mock_server
