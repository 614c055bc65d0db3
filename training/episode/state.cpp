// The full state of an episode as numbers: ball, clock and all players of the cast.
#include "soccer/per_side.h"
#include "soccer/pitch.h"
#include "training/episode/setup.h"
#include "training/features/feature_writer.h"

namespace cls::training {
namespace {

constexpr double kPlayerSpeed = 1.2;
constexpr double kBallSpeed = 3.0;
constexpr int kPlayerColumns = 8;

void add_player(const simulator::World& world, int slot, FeatureWriter& out) {
  const simulator::Player& player = world.player(slot);
  out.flag(player.enabled);
  if (!player.enabled) return out.same(kPlayerColumns - 1, 0.0F);
  out.value(player.position.x / soccer::kHalfLength, -1.2, 1.2);
  out.value(player.position.y / soccer::kHalfWidth, -1.2, 1.2);
  out.value(player.velocity.x / kPlayerSpeed);
  out.value(player.velocity.y / kPlayerSpeed);
  out.angle(player.body);
  out.value(player.stamina.value / world.params().stamina_max, 0.0);
}

}  // namespace

Columns state_columns(const Cast& cast) {
  Columns out = {{"ball_x", "52.5 m", -1.2F, 1.2F},
                 {"ball_y", "34 m", -1.2F, 1.2F},
                 {"ball_vx", "3 m/cycle", -1, 1},
                 {"ball_vy", "3 m/cycle", -1, 1},
                 {"play_on", "0/1", -1, 1},
                 {"time_left", "1", 0, 1},
                 {"score_difference", "goals", -20, 20}};

  for (const Side side : soccer::kBothSides) {
    for (const int slot : cast.team(side)) {
      const std::string name = agent_name(slot);
      append(out, name, {"_on_pitch"}, "0/1");
      append(out, name, {"_x"}, "52.5 m", -1.2F, 1.2F);
      append(out, name, {"_y"}, "34 m", -1.2F, 1.2F);
      append(out, name, {"_vx", "_vy"}, "1.2 m/cycle");
      append(out, name, {"_body_sin", "_body_cos"});
      append(out, name, {"_stamina"}, "8000", 0);
    }
  }
  return out;
}

void fill_state(const simulator::World& world, const Cast& cast, double time_left, float* numbers) {
  FeatureWriter out(numbers);
  out.value(world.ball.position.x / soccer::kHalfLength, -1.2, 1.2);
  out.value(world.ball.position.y / soccer::kHalfWidth, -1.2, 1.2);
  out.value(world.ball.velocity.x / kBallSpeed);
  out.value(world.ball.velocity.y / kBallSpeed);
  out.flag(world.mode == soccer::PlayMode::kPlayOn);
  out.value(time_left, 0.0);
  out.value(world.team(Side::kLeft).score - world.team(Side::kRight).score, -20.0, 20.0);

  for (const Side side : soccer::kBothSides) {
    for (const int slot : cast.team(side)) add_player(world, slot, out);
  }
}

}  // namespace cls::training
