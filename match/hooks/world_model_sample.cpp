// Turns world models into the coordinates of the game log.
#include "match/hooks/world_model_sample.h"

#include "base/index.h"

namespace cls::match {
namespace {

using soccer::Side;
using viewer::DecisionSample;

int age_of(int count) { return count < player::kNever ? count : viewer::kUnknownAge; }

/// The own team attacks +x in a world model, the left team in a log.
class View {
 public:
  explicit View(Side side) : sign_(soccer::sign(side)) {}
  soccer::Vec2 point(soccer::Vec2 p) const { return {sign_ * p.x, sign_ * p.y}; }
  double direction(soccer::AngleDeg angle) const {
    return (sign_ > 0 ? angle : angle + 180.0).degrees();
  }

 private:
  int sign_;
};

viewer::EstimatedPlayer estimate(const player::PlayerState& player, View view) {
  return {age_of(player.pos_count), view.point(player.position)};
}

void add_players(const player::PlayerList& players, View view, DecisionSample& sample) {
  for (const player::PlayerState& player : players) {
    const viewer::EstimatedPlayer known = estimate(player, view);
    if (player.unum > 0 && player.side != Side::kNeutral) {
      sample.players.at(base::index(soccer::slot_of(player.side, player.unum))) = known;
    } else if (known.age != viewer::kUnknownAge) {
      sample.unnumbered.push_back({player.id, player.side, known});
    }
  }
}

}  // namespace

DecisionSample sample_of(const player::WorldModel& world) {
  const View view(world.our_side);
  DecisionSample sample;
  sample.cycle = world.game.time.cycle;
  sample.stopped = world.game.time.stopped;

  sample.self = view.point(world.self.position);
  sample.self_body = view.direction(world.self.body);
  sample.self_neck = world.self.neck.degrees();
  sample.self_age = age_of(world.self.pos_count);

  sample.ball = view.point(world.ball.position);
  sample.ball_velocity = view.point(world.ball.velocity);
  sample.ball_age = age_of(world.ball.pos_count);
  sample.ball_velocity_age = age_of(world.ball.vel_count);

  for (const player::PlayerList* list : {&world.teammates, &world.opponents, &world.unknowns}) {
    add_players(*list, view, sample);
  }

  sample.own_reach = age_of(world.intercept.best_self_steps());
  sample.teammate_reach = age_of(world.intercept.first_teammate_steps);
  sample.opponent_reach = age_of(world.intercept.first_opponent_steps);
  return sample;
}

}  // namespace cls::match
