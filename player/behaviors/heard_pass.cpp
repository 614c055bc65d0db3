// Runs to the receive point of an announced pass.
#include "player/behaviors/behaviors.h"

#include <optional>

#include "player/movement/movement.h"
#include "player/perception/say_message.h"
#include "player/world/motion.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

constexpr int kPatience = 5;  ///< cycles to follow an announced pass without seeing it

std::optional<Vec2> announced_point(const WorldModel& world) {
  for (const HeardMessage& heard : world.heard) {
    if (heard.coach || heard.side != world.our_side || heard.unum == world.unum) continue;
    std::string_view text = heard.text;
    while (const auto message = parse_say_message(text, world.server())) {
      const auto* pass = std::get_if<SayPass>(&*message);
      if (pass != nullptr && pass->receiver == world.unum) return pass->point;
    }
  }

  return std::nullopt;
}

bool receive(ActionContext& c, Vec2 point) {
  const WorldModel& world = c.world;
  c.neck.kind = NeckPlan::Kind::kBall;

  const bool ball_known = world.ball.pos_count <= 1 && world.ball.vel_count <= 1;
  if (!world.kickable_teammate() && ball_known && world.intercept.best_self_steps() < 20) {
    return intercept(world, c.slots, true, kOpponentGoal);
  }

  if (!go_to_point(world, c.slots, point, 0.5, world.server().max_dash_power)) {
    turn_to_ball(world, c.slots);
  }
  return c.slots.has_body();
}

}  // namespace

bool receive_heard_pass(ActionContext& c) {
  const WorldModel& world = c.world;
  if (world.self.kickable || world.self.frozen()) return false;
  const std::optional<Vec2> point = announced_point(world);
  if (!point || !receive(c, *point)) return false;

  c.memory.intention = {.kind = Intention::Kind::kReceive,
                        .target = *point,
                        .dashes = kPatience,
                        .last = world.game.time};
  return true;
}

bool continue_reception(ActionContext& c) {
  const WorldModel& world = c.world;
  Intention& intention = c.memory.intention;
  const bool in_time = world.game.time.cycle == intention.last.cycle + 1;
  const bool there = distance(world.self.position, intention.target) < 0.9;
  const bool over = world.self.kickable || world.kickable_teammate() ||
                    world.ball.dist_from_self < 3.0 || there || !in_time || intention.dashes <= 0;

  if (over || !receive(c, intention.target)) {
    intention.clear();
    return false;
  }
  --intention.dashes;
  intention.last = world.game.time;
  return true;
}

}  // namespace cls::player
