// The decisions of the example team: examples/TEAM.md describes them, in the same order.
#include "mock-server/behavior/example_team.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/index.h"
#include "mock-server/behavior/example_situation.h"

namespace cls::mock_server {
namespace example {
namespace {

using soccer::Vec2;

// A position with the ball at the center mark, and how much of the ball's way it follows.
struct Home {
  double x, y, follow_x, follow_y, min_x, max_x;
  Vec2 kick_off;
};

// A 4-3-3 by uniform number; 1 is the goalie.
constexpr std::array<Home, 11> kFormation{{
    {-50, 0, 0, 0, -50, -50, {-50, 0}},
    {-20, -7, 0.60, 0.25, -45, 14, {-20, -7}},
    {-20, 7, 0.60, 0.25, -45, 14, {-20, 7}},
    {-17, -20, 0.65, 0.25, -43, 28, {-18, -20}},
    {-17, 20, 0.65, 0.25, -43, 28, {-18, 20}},
    {-7, 0, 0.70, 0.45, -38, 32, {-11, 0}},
    {1, -12, 0.75, 0.35, -34, 40, {-8, -11}},
    {1, 12, 0.75, 0.35, -34, 40, {-8, 11}},
    {15, -25, 0.75, 0.15, -24, 47, {-1.5, -22}},
    {15, 25, 0.75, 0.15, -24, 47, {-1.5, 22}},
    {18, 0, 0.75, 0.30, -16, 47, {-0.8, 0}},
}};

// 0, 37, -37, 53 and -53 degrees: exact sides of a right triangle.
constexpr std::array<Vec2, 5> kDribbleDirections{
    {{1, 0}, {0.8, 0.6}, {0.8, -0.6}, {0.6, 0.8}, {0.6, -0.8}}};

constexpr int kMarker = 2;  // the center back of Defense::kOneMarks

struct Pass {
  Vec2 target;
  double speed, value;
};

const Home& home_of(const protos::Self& self) {
  const int unum = std::clamp(self.uniform_number(), 1, static_cast<int>(kFormation.size()));
  return kFormation[base::index(unum - 1)];
}

void set(Vec2 place, protos::RpcVector2D& vector) {
  vector.set_x(static_cast<float>(place.x + 0.0));  // never a negative zero
  vector.set_y(static_cast<float>(place.y + 0.0));
}

void smart_kick(Vec2 target, double speed, double min_speed, int kicks,
                protos::PlayerActions& actions) {
  protos::Body_SmartKick& kick = *actions.add_actions()->mutable_body_smart_kick();
  set(target, *kick.mutable_target_point());
  kick.set_first_speed(static_cast<float>(speed));
  kick.set_first_speed_threshold(static_cast<float>(min_speed));
  kick.set_max_steps(kicks);
}

void dribble(Vec2 target, double dash_power, int dashes, protos::PlayerActions& actions) {
  protos::Body_Dribble& dribble = *actions.add_actions()->mutable_body_dribble();
  set(target, *dribble.mutable_target_point());
  dribble.set_distance_threshold(1);
  dribble.set_dash_power(static_cast<float>(dash_power));
  dribble.set_dash_count(dashes);
  dribble.set_dodge(true);
}

void go_to(Vec2 target, double within, double dash_power, protos::PlayerActions& actions) {
  protos::Body_GoToPoint& go = *actions.add_actions()->mutable_body_go_to_point();
  set(target, *go.mutable_target_point());
  go.set_distance_threshold(static_cast<float>(within));
  go.set_max_dash_power(static_cast<float>(dash_power));
}

void hold_ball(protos::PlayerActions& actions) {
  protos::Body_HoldBall& hold = *actions.add_actions()->mutable_body_hold_ball();
  hold.set_do_turn(true);
  set(kGoal, *hold.mutable_turn_target_point());
  set(kGoal, *hold.mutable_kick_target_point());
}

// The neck: to the ball if its estimate is older than max_age cycles, else around.
void watch_ball(int max_age, protos::PlayerActions& actions) {
  actions.add_actions()->mutable_neck_turn_to_ball_or_scan()->set_count_threshold(max_age);
}

// The place between the posts that opponents are farthest from.
std::optional<Vec2> shot(const Situation& now) {
  if (distance(now.ball, kGoal) > 20) return std::nullopt;

  std::optional<Vec2> best;
  double widest = 0;
  for (const double y : {-6.0, -3.0, 0.0, 3.0, 6.0}) {
    const Vec2 target{kGoal.x, y};
    const double margin = lane(now, now.ball, target);
    if (margin <= widest) continue;
    best = target;
    widest = margin;
  }
  return best;
}

// Of the ball at a place: forward, near the goal, away from opponents.
double value(const Situation& now, Vec2 place) {
  return place.x - 0.2 * distance(place, kGoal) + 0.6 * std::min(room(now, place), 8.0);
}

bool can_receive(const Situation& now, const protos::Player& mate) {
  if (mate.pos_count() > 8 || mate.is_goalie() || mate.is_tackling()) return false;

  const double x = mate.position().x();
  const double line = static_cast<double>(now.world->offside_line_x()) - 0.3;
  const bool offside = x > 0 && x > line && x > now.ball.x;
  return !offside;
}

// Two cycles of the teammate's run ahead, and 3 m forward.
Vec2 pass_target(const protos::Player& mate) {
  const Vec2 place = point_of(mate.position());
  const Vec2 run = point_of(mate.velocity());
  const double ahead = place.x >= 36 ? 0 : 3;
  return {std::clamp(place.x + 2 * run.x + ahead, -50.0, 50.0),
          std::clamp(place.y + 2 * run.y, -32.0, 32.0)};
}

std::optional<Pass> best_pass(const Situation& now) {
  std::optional<Pass> best;

  for (const protos::Player& mate : now.world->teammates()) {
    if (!can_receive(now, mate)) continue;

    const Vec2 target = pass_target(mate);
    const double way = distance(now.ball, target);
    const bool toward_own_goal = target.x < -25 && target.x < now.ball.x;
    if (way < 5 || way > 32 || toward_own_goal) continue;
    if (lane(now, now.ball, target) < 0) continue;

    const Pass option{target, std::min(1.2 + 0.06 * way, 2.7), value(now, target)};
    if (!best || option.value > best->value) best = option;
  }

  return best;
}

// 8 m ahead toward the goal, past the opponents in the way.
Vec2 dribble_target(const Situation& now) {
  const double away = distance(now.me, kGoal);
  if (away < 0.1) return kGoal;

  const double dx = (kGoal.x - now.me.x) / away;
  const double dy = (kGoal.y - now.me.y) / away;
  Vec2 best = kGoal;
  double best_room = -1000;
  double loss = 0;

  for (const Vec2& turn : kDribbleDirections) {
    const Vec2 target{now.me.x + 8 * (dx * turn.x - dy * turn.y),
                      now.me.y + 8 * (dx * turn.y + dy * turn.x)};
    const bool outside = target.y < -32 || target.y > 32 || target.x > 51;
    const double free = outside ? best_room : std::min(lane(now, now.me, target), 4.0) - loss;
    loss += 0.5;
    if (free <= best_room) continue;
    best = target;
    best_room = free;
  }

  return best;
}

void play_with_ball(const Situation& now, protos::PlayerActions& actions) {
  actions.add_actions()->mutable_helios_shoot();
  const std::optional<Vec2> corner = shot(now);
  if (corner) smart_kick(*corner, 3, 2, 2, actions);

  const bool pressed = room(now, now.ball) < 3;
  const std::optional<Pass> pass = best_pass(now);
  if (pass && (pressed || pass->value > value(now, now.ball) + 2)) {
    smart_kick(pass->target, pass->speed, pass->speed * 0.8, 3, actions);
  }

  if (pressed && now.ball.x < -20) actions.add_actions()->mutable_body_clear_ball();
  dribble(dribble_target(now), 90, pressed ? 2 : 4, actions);
  hold_ball(actions);

  if (corner) {
    actions.add_actions()->mutable_neck_turn_to_goalie_or_scan();
  } else {
    watch_ball(0, actions);
  }
}

// The formation moves with the ball; forwards wait on the offside line.
Vec2 home_position(const Situation& now) {
  const Home& own = home_of(*now.self);
  const double line = static_cast<double>(now.world->offside_line_x()) - 0.5;
  double x = std::clamp(own.x + own.follow_x * now.ball.x, own.min_x, own.max_x);
  if (now.self->uniform_number() >= 9) x = std::max(x, std::min({line, now.ball.x + 22, 46.0}));
  x = std::min(x, std::max(line, 0.0));
  return {x, std::clamp(own.y + own.follow_y * now.ball.y, -32.0, 32.0)};
}

// Stamina must last for a half.
double dash_power(const Situation& now, Vec2 target) {
  if (now.self->stamina() < 3500) return 35;
  return now.me.x > target.x + 3 || distance(now.ball, target) < 15 ? 100 : 65;
}

void play_without_ball(const Situation& now, ExampleTeam::Defense defense,
                       protos::PlayerActions& actions) {
  const bool first = now.my_steps <= now.our_steps;
  const bool may_mark =
      defense == ExampleTeam::Defense::kAllMark || now.self->uniform_number() == kMarker;
  const bool marks = may_mark && now.their_steps <= now.our_steps;

  if (first && now.my_steps <= now.their_steps + 1) {
    set(kGoal, *actions.add_actions()->mutable_body_intercept()->mutable_face_point());
    actions.add_actions()->mutable_body_turn_to_ball()->set_cycle(1);
    watch_ball(0, actions);
  } else if (first || marks) {
    actions.add_actions()->mutable_helios_basic_move();
    watch_ball(1, actions);
  } else {
    const Vec2 place = home_position(now);
    go_to(place, 0.8, dash_power(now, place), actions);
    actions.add_actions()->mutable_body_turn_to_ball()->set_cycle(1);
    watch_ball(2, actions);
  }
}

// The proxy would place players by its own formation.
void prepare_kick_off(const protos::Self& self, protos::PlayerActions& actions) {
  actions.set_ignore_preprocess(true);
  set(home_of(self).kick_off,
      *actions.add_actions()->mutable_bhv_before_kick_off()->mutable_point());
  watch_ball(0, actions);
}

}  // namespace
}  // namespace example

void ExampleTeam::decide(const protos::State& state, protos::PlayerActions& actions) const {
  const protos::WorldModel& world = state.world_model();
  const protos::GameModeType mode = world.game_mode_type();

  if (world.is_penalty_kick_mode()) {
    actions.add_actions()->mutable_helios_penalty();
  } else if (mode == protos::BeforeKickOff || mode == protos::AfterGoal_) {
    example::prepare_kick_off(world.self(), actions);
  } else if (mode != protos::PlayOn) {
    actions.add_actions()->mutable_helios_set_play();
  } else if (world.self().is_goalie()) {
    actions.add_actions()->mutable_helios_goalie();
  } else if (world.self().is_kickable()) {
    example::play_with_ball(example::situation_of(world), actions);
  } else {
    example::play_without_ball(example::situation_of(world), defense_, actions);
  }
}

void ExampleTeam::decide_as_coach(const protos::State& /*state*/,
                                  protos::CoachActions& actions) const {
  actions.add_actions()->mutable_do_helios_substitute();
  actions.add_actions()->mutable_do_helios_say_player_types();
}

}  // namespace cls::mock_server
