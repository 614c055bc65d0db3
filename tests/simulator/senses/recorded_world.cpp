// Reconstructs worlds from recorded frames.
#include "tests/simulator/senses/recorded_world.h"

#include "soccer/math.h"
#include "soccer/parameters/player_type.h"
#include "tests/support/rcg_lines.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

constexpr double kSynchronousWidths[] = {60.0, 120.0, 180.0};
constexpr int kTackleCycles = 9;
constexpr int kFoulCycles = 4;

// Remaining cycles of lasting states, after the step of the frame.
struct Timers {
  int tackle = 0;
  int foul = 0;
  int arm = 20;
};

void set_view(View& view, const gamelog::PlayerFrame& frame) {
  view.synchronous = true;
  for (int width = 0; width < 3; ++width) {
    if (frame.view_width == kSynchronousWidths[width]) {
      view.width = static_cast<soccer::ViewWidth>(width);
    }
  }
  view.focus_distance = frame.focus_distance;
  view.focus_direction = math::to_radians(frame.focus_direction);
}

void set_player(Player& player, const gamelog::PlayerFrame& frame, const Timers& timers) {
  player.client_version = 18;
  player.joined = true;
  player.state = frame.state;
  player.enabled = player.has(state::kStand);
  player.goalie = player.has(state::kGoalie);

  player.type = frame.type;
  player.position = frame.position;
  player.velocity = frame.velocity;
  player.body = math::to_radians(frame.body);
  player.neck = math::to_radians(frame.neck);

  player.stamina = {frame.stamina, frame.effort, frame.recovery, frame.capacity};
  player.counters = frame.counts;
  player.kick_cycles = player.has(state::kKick | state::kKickFault) ? 0 : -1;
  player.tackle_cycles = timers.tackle;
  player.foul_cycles = timers.foul;
  player.arm.age = timers.arm;

  player.contacts = {player.has(state::kBallCollide), player.has(state::kPlayerCollide),
                     player.has(state::kPostCollide)};
  player.attention = frame.attention_side == Side::kNeutral
                         ? kNoPlayer
                         : soccer::slot_of(frame.attention_side, frame.attention_unum);
  set_view(player.view, frame);
}

void count(Timers& timers, const gamelog::PlayerFrame* before, const gamelog::PlayerFrame& now,
           const gamelog::PlayerFrame* after) {
  ++timers.arm;
  if (before != nullptr && now.counts.pointto > before->counts.pointto) {
    timers.arm = now.pointing_at ? 1 : 21;
  }
  timers.tackle = std::max(0, timers.tackle - 1);
  if (before != nullptr && now.counts.tackle > before->counts.tackle) {
    // A successful foul blocks only the victim.
    const bool lasts = after != nullptr && (after->state & (state::kTackle | state::kTackleFault));
    timers.tackle = lasts ? kTackleCycles : 0;
  }
  timers.foul = std::max(0, timers.foul - 1);
  const bool was_charged = before != nullptr && (before->state & state::kFoulCharged);
  if ((now.state & state::kFoulCharged) && !was_charged) timers.foul = kFoulCycles;
}

double moved(double value, double half_step, RandomStream& random) {
  return value + random.uniform(-half_step, half_step);
}

Vec2 moved(Vec2 value, double half_step, RandomStream& random) {
  const double x = moved(value.x, half_step, random);
  return {x, moved(value.y, half_step, random)};
}

}  // namespace

std::shared_ptr<const Rules> unlimited_vision_rules() {
  auto rules = *make_rules(soccer::ServerParams{}, soccer::PlayerParams{}, 1);
  Rules unlimited = *rules;
  for (soccer::PlayerType& type : unlimited.types) {
    for (const auto member :
         {&soccer::PlayerType::flag_chg_far_length, &soccer::PlayerType::flag_chg_too_far_length,
          &soccer::PlayerType::ball_vel_far_length, &soccer::PlayerType::ball_vel_too_far_length,
          &soccer::PlayerType::unum_far_length, &soccer::PlayerType::unum_too_far_length}) {
      type.*member = 1000.0;
    }
  }
  return std::make_shared<const Rules>(std::move(unlimited));
}

std::vector<World> recorded_worlds(std::shared_ptr<const Rules> rules, std::string_view log) {
  const std::vector<gamelog::Frame> frames = tests::read_frames(log);
  std::array<Timers, soccer::kPlayersOnPitch> timers;
  std::vector<World> worlds;
  World world = make_world(std::move(rules), 1);

  for (std::size_t i = 0; i < frames.size(); ++i) {
    const gamelog::Frame& frame = frames[i];
    const bool same_time = i > 0 && frames[i - 1].time == frame.time;
    world.clock = {frame.time, same_time ? world.clock.stoppage + 1 : 0};
    world.mode = frame.mode;
    world.ball = {frame.ball_position, frame.ball_velocity, {}};
    for (std::size_t k = 0; k < 2; ++k) world.teams[k].name = soccer::TeamName(frame.teams[k].name);
    for (std::size_t slot = 0; slot < timers.size(); ++slot) {
      count(timers[slot], i > 0 ? &frames[i - 1].players[slot] : nullptr, frame.players[slot],
            i + 1 < frames.size() ? &frames[i + 1].players[slot] : nullptr);
      set_player(world.players[slot], frame.players[slot], timers[slot]);
    }
    worlds.push_back(world);
  }

  return worlds;
}

World jittered(const World& world, RandomStream& random) {
  constexpr double kLength = 0.5e-4;
  const double angle = math::to_radians(0.5e-3);
  World result = world;
  result.ball.position = moved(world.ball.position, kLength, random);
  result.ball.velocity = moved(world.ball.velocity, kLength, random);
  for (Player& player : result.players) {
    player.position = moved(player.position, kLength, random);
    player.velocity = moved(player.velocity, kLength, random);
    player.body = math::normalize_radians(moved(player.body, angle, random));
    player.neck = moved(player.neck, angle, random);
  }
  return result;
}

}  // namespace cls::simulator
