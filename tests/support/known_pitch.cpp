// Copies the simulator state into the agent's estimates.
#include "tests/support/known_pitch.h"

#include <memory>
#include <stdexcept>
#include <utility>

#include "player/commands/command_slots.h"
#include "player/perception/perception.h"
#include "player/world/planner_parameters.h"
#include "player/world/view_cone.h"
#include "proxy/actions/executor.h"
#include "simulator/actions/actions.h"
#include "simulator/step.h"
#include "simulator/world/roster.h"

namespace cls::tests {
namespace {

using player::PlayerState;
using soccer::AngleDeg;
using soccer::Side;
using soccer::Vec2;
namespace math = soccer::math;

constexpr int kUnum = 7;

simulator::World make_truth(Noise noise, std::uint64_t seed) {
  soccer::ServerParams server;
  soccer::PlayerParams player;
  player.player_types = 1;
  server.wind_none = true;
  if (noise == Noise::kNone) server.player_rand = server.ball_rand = server.kick_rand = 0.0;
  const auto rules = simulator::make_rules(server, player, seed);
  if (!rules) throw std::runtime_error(rules.error().message);
  simulator::World truth = simulator::make_world(*rules, seed);
  constexpr int kVersion = 18;

  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
      simulator::join(truth, side, false, kVersion);
      truth.player(side, unum).enabled = side == Side::kLeft && unum == kUnum;
    }
  }
  truth.mode = soccer::PlayMode::kPlayOn;
  truth.clock = {100, 0};
  return truth;
}

void put(simulator::Player& player, Vec2 position, double body_deg, Vec2 velocity) {
  player.position = position;
  player.velocity = velocity;
  player.acceleration = {};
  player.body = player.pending_body = math::to_radians(body_deg);
}

}  // namespace

void allow_everything(protos::HeliosOffensivePlanner& planner) {
  planner.set_direct_pass(true);
  planner.set_lead_pass(true);
  planner.set_through_pass(true);
  planner.set_short_dribble(true);
  planner.set_long_dribble(true);
  planner.set_cross(true);
  planner.set_simple_pass(true);
  planner.set_simple_dribble(true);
  planner.set_simple_shoot(true);
}

void disable_automatic_behavior(protos::PlayerActions& reply) {
  reply.set_ignore_preprocess(true);
  reply.set_ignore_shootinpreprocess(true);
  reply.set_ignore_dointention(true);
  reply.set_ignore_doforcekick(true);
}

KnownPitch::KnownPitch(Noise noise, std::uint64_t seed) : truth_(make_truth(noise, seed)) {
  auto parameters = std::make_shared<player::MatchParameters>();
  parameters->server = truth_.params();
  parameters->types = truth_.rules->types;
  world.parameters = parameters;
  world.our_side = Side::kLeft;
  world.unum = kUnum;
  world.self.pos_count = world.self.vel_count = world.self.body_count = 0;
  self().view.synchronous = true;
  self().view.width = soccer::ViewWidth::kNarrow;
  put(self(), {}, 0.0, {});
  place_ball({30.0, 20.0});
}

simulator::Player& KnownPitch::self() { return truth_.player(Side::kLeft, kUnum); }
const simulator::Player& KnownPitch::self() const { return truth_.player(Side::kLeft, kUnum); }

void KnownPitch::place_self(Vec2 position, double body_deg, Vec2 velocity) {
  put(self(), position, body_deg, velocity);
  update_world();
}

void KnownPitch::place_ball(Vec2 position, Vec2 velocity) {
  truth_.ball = {position, velocity, {}};
  player::BallState& ball = world.ball;
  ball.pos_count = ball.relative_pos_count = ball.vel_count = 0;
  ball.seen_pos_count = ball.seen_vel_count = 0;
  update_world();
}

void KnownPitch::add(player::PlayerList& list, Side side, int unum, Vec2 position, double body_deg,
                     int age) {
  simulator::Player& player = truth_.player(side, unum);
  player.enabled = true;
  put(player, position, body_deg, {});
  player::PlayerState estimate;
  estimate.id = world.next_player_id++;
  estimate.side = side;
  estimate.unum = unum;
  estimate.goalie = unum == 1;
  estimate.pos_count = estimate.seen_pos_count = estimate.vel_count = estimate.seen_vel_count = age;
  estimate.body_count = estimate.face_count = estimate.unum_count = age;
  list.push_back(estimate);
  update_world();
}

void KnownPitch::add_teammate(int unum, Vec2 position, double body_deg, int age) {
  add(world.teammates, Side::kLeft, unum, position, body_deg, age);
}

void KnownPitch::add_opponent(int unum, Vec2 position, double body_deg, int age) {
  add(world.opponents, Side::kRight, unum, position, body_deg, age);
}

void KnownPitch::set_mode(soccer::PlayMode mode) {
  truth_.mode = mode;
  truth_.kick_off_side = Side::kLeft;
  update_world();
}

void KnownPitch::set_shoot_out(soccer::PlayMode mode) {
  auto& rule = truth_.referee.penalty;
  rule.started = true;
  rule.goal_side = Side::kRight;
  rule.taker_side = soccer::side(mode);
  rule.timer = truth_.params().pen_taken_wait;
  rule.previous_ball = truth_.ball.position;
  player::PenaltyState& penalty = world.game.penalty;
  penalty.field_side = Side::kRight;
  penalty.taker = soccer::side(mode);
  penalty.our_taken = penalty.their_taken = 1;
  penalty.cycle = truth_.clock.time;
  set_mode(mode);
}

void KnownPitch::set_parameter(std::string_view name, double value) {
  auto parameters = std::make_shared<player::PlannerParameters>(*world.planner);
  if (const auto set = set_planner_parameter(*parameters, name, value); !set) {
    throw std::invalid_argument(set.error().message);
  }
  world.planner = std::move(parameters);
}

void KnownPitch::set_time(int cycle, int stopped) {
  truth_.clock = {cycle, stopped};
  update_world();
}

void KnownPitch::set_neck(double degrees) {
  self().neck = self().pending_neck = math::to_radians(degrees);
  update_world();
}

void KnownPitch::set_stamina(double stamina) {
  self().stamina.value = stamina;
  update_world();
}

void KnownPitch::set_focus(double distance, double degrees) {
  self().view.focus_distance = distance;
  self().view.focus_direction = math::to_radians(degrees);
  update_world();
}

void KnownPitch::make_goalie() {
  self().goalie = world.goalie = true;
  update_world();
}

void KnownPitch::knock_down(int cycles) {
  self().tackle_cycles = cycles;
  self().command_done = true;
  update_world();
}

void KnownPitch::update_self() {
  player::SelfState& estimate = world.self;
  const simulator::Player& player = self();
  estimate.position = estimate.seen_position = player.position;
  estimate.velocity = estimate.seen_velocity = player.velocity;
  estimate.body = AngleDeg(math::to_degrees(player.body));
  estimate.neck = AngleDeg(math::to_degrees(player.neck));
  estimate.stamina = player.stamina.value;
  estimate.effort = player.stamina.effort;
  estimate.recovery = player.stamina.recovery;
  estimate.capacity = player.stamina.capacity;
  estimate.view_width = player.view.width;
  estimate.focus_distance = player.view.focus_distance;
  estimate.focus_direction = AngleDeg(math::to_degrees(player.view.focus_direction));
  estimate.tackle_expires_in = player.tackle_cycles;
  estimate.foul_charged = player.foul_cycles;
  estimate.catch_ban = player.catch_ban;
  estimate.arm.movable_in = simulator::can_point(truth_, player) ? 0 : 1;
}

void KnownPitch::update_player(player::PlayerState& estimate) const {
  const simulator::Player& player = truth_.player(estimate.side, estimate.unum);
  estimate.position = estimate.seen_position = player.position;
  estimate.velocity = estimate.seen_velocity = player.velocity;
  estimate.body = estimate.face = AngleDeg(math::to_degrees(player.body));
}

void KnownPitch::update_world() {
  world.game.time = {truth_.clock.time, truth_.clock.stoppage};
  world.game.last_see = world.game.time;
  world.game.see_time = truth_.clock.time;
  world.game.mode = truth_.mode;
  update_self();
  for (player::PlayerState& player : world.teammates) update_player(player);
  for (player::PlayerState& player : world.opponents) update_player(player);
  world.ball.position = truth_.ball.position;
  world.ball.velocity = truth_.ball.velocity;
  world.ball.relative_position = truth_.ball.position - self().position;
  player::update_derived(world);
}

void KnownPitch::act(const protos::PlayerActions& reply) {
  player::CommandSlots slots(world);
  proxy::execute(reply, world, memory, slots, report);
  slots.compose(commands);
  step();
}

void KnownPitch::act(const std::function<void(protos::PlayerActions&)>& fill) {
  protos::PlayerActions reply;
  disable_automatic_behavior(reply);
  fill(reply);
  act(reply);
}

int KnownPitch::act_until(int cycles, const std::function<void(protos::PlayerActions&)>& fill,
                          const std::function<bool()>& done) {
  int cycle = 0;
  for (; cycle < cycles && !done(); ++cycle) act(fill);
  return cycle;
}

void KnownPitch::roll(int cycles) {
  commands.clear();
  for (int i = 0; i < cycles; ++i) step();
}

void KnownPitch::step() {
  for (const soccer::PlayerCommand& command : commands) {
    simulator::apply(truth_, self().slot(), command, events_);
  }
  simulator::step(truth_, events_);
  simulator::finish_step(truth_, events_);
  events_.clear();
  update_world();
}

bool KnownPitch::sees(Vec2 point) const {
  const AngleDeg direction = AngleDeg::of(point - self().position);
  const AngleDeg face(math::to_degrees(simulator::face_direction(self())));
  const double cone =
      math::to_degrees(simulator::view_cone(self().view, truth_.params().visible_angle));
  return (direction - face).abs() < cone / 2.0;
}

Vec2 KnownPitch::focus_point() const { return simulator::focus_point(self()); }

const player::ActionCounts& KnownPitch::counts(protos::PlayerAction::ActionCase member) const {
  return report.actions[static_cast<std::size_t>(member)];
}

}  // namespace cls::tests
