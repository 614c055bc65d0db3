// Copies worlds to the struct of the C interface, and starts from it.
#include "training/c_api/world_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/index.h"
#include "soccer/math.h"

namespace cls::training {
namespace {

using base::Error;
using base::Result;

constexpr double kDegrees = 180.0 / soccer::math::kPi;
// No ball or player of a match is beyond these.
constexpr double kMaxPosition = 200.0;
constexpr double kMaxSpeed = 20.0;
constexpr double kMaxAngle = 360.0;
constexpr double kMaxCapacity = 1e7;
constexpr int kMaxCount = 1'000'000;
constexpr int kMaxBlocked = 1000;
constexpr int kMaxCards = 2;

cls_training_player to_player(const simulator::World& world, const simulator::Player& player) {
  cls_training_player out = {};
  out.side = soccer::sign(player.side);
  out.unum = player.unum;
  out.on_pitch = player.enabled ? 1 : 0;
  out.goalie = player.goalie ? 1 : 0;

  out.x = player.position.x;
  out.y = player.position.y;
  out.vx = player.velocity.x;
  out.vy = player.velocity.y;
  out.body = player.body * kDegrees;
  out.neck = player.neck * kDegrees;
  out.stamina = player.stamina.value;
  out.effort = player.stamina.effort;
  out.recovery = player.stamina.recovery;
  out.capacity = player.stamina.capacity;
  out.kickable_area = world.type_of(player).kickable_area(world.params().ball_size);

  out.tackle_cycles = player.tackle_cycles;
  out.foul_cycles = player.foul_cycles;
  out.catch_ban = player.catch_ban;
  out.cards = player.cards;
  out.type = player.type;
  return out;
}

// Names the first value that is out of its range.
class Ranges {
 public:
  explicit Ranges(std::string of) : of_(std::move(of)) {}

  void check(std::string_view field, double value, double low, double high) {
    if (!error.empty() || (std::isfinite(value) && value >= low && value <= high)) return;
    error = fmt::format("{}{}: {:g} is not between {:g} and {:g}", of_, field, value, low, high);
  }

  std::string error;

 private:
  std::string of_;
};

Result<StartPlayer> read_player(const cls_training_player& in, int slot,
                                const simulator::Rules& rules) {
  StartPlayer out;
  out.on_pitch = in.on_pitch != 0;
  if (!out.on_pitch) {
    out.cards = std::clamp(in.cards, 0, kMaxCards);
    return out;
  }

  Ranges ranges(fmt::format("players[{}].", slot));
  for (const auto& [name, value] : {std::pair{"x", in.x}, {"y", in.y}}) {
    ranges.check(name, value, -kMaxPosition, kMaxPosition);
  }
  for (const auto& [name, value] : {std::pair{"vx", in.vx}, {"vy", in.vy}}) {
    ranges.check(name, value, -kMaxSpeed, kMaxSpeed);
  }
  for (const auto& [name, value] : {std::pair{"body", in.body}, {"neck", in.neck}}) {
    ranges.check(name, value, -kMaxAngle, kMaxAngle);
  }
  ranges.check("stamina", in.stamina, 0.0, rules.server.stamina_max);
  ranges.check("effort", in.effort, 0.0, 1.0);
  ranges.check("recovery", in.recovery, 0.0, 1.0);
  ranges.check("capacity", in.capacity, -1.0, kMaxCapacity);
  ranges.check("tackle_cycles", in.tackle_cycles, 0, kMaxBlocked);
  ranges.check("foul_cycles", in.foul_cycles, 0, kMaxBlocked);
  ranges.check("catch_ban", in.catch_ban, 0, kMaxBlocked);
  ranges.check("cards", in.cards, 0, kMaxCards);
  ranges.check("type", in.type, 0, static_cast<double>(rules.types.size()) - 1.0);
  if (!ranges.error.empty()) return Error{std::move(ranges.error)};

  out.position = {in.x, in.y};
  out.velocity = {in.vx, in.vy};
  out.body = in.body / kDegrees;
  out.neck = in.neck / kDegrees;
  out.stamina = {in.stamina, in.effort, in.recovery, in.capacity};
  out.tackle_cycles = in.tackle_cycles;
  out.foul_cycles = in.foul_cycles;
  out.catch_ban = in.catch_ban;
  out.cards = in.cards;
  out.type = in.type;
  return out;
}

Result<soccer::PlayMode> read_mode(const cls_training_world& world, const Setup& setup) {
  const std::string_view text(world.play_mode, ::strnlen(world.play_mode, sizeof world.play_mode));
  const auto mode = soccer::parse_play_mode(text);
  if (!mode) return Error{fmt::format("play_mode: '{}' is not a play mode", text)};

  const bool has_set_plays = setup.task->referee && soccer::is_set_play(*mode);
  if (has_set_plays || *mode == soccer::PlayMode::kPlayOn || *mode == setup.prepared.mode) {
    return *mode;
  }
  return Error{fmt::format("play_mode: an episode of {} cannot start in {}", setup.task->id, text)};
}

Result<void> read_world(const cls_training_world& world, const Setup& setup, Start& out) {
  Ranges ranges("");
  ranges.check("cycle", world.cycle, 0, setup.max_cycles - 1);
  ranges.check("time", world.time, 0, kMaxCount);
  for (const int score : world.score) ranges.check("score", score, 0, kMaxCount);
  ranges.check("last_touch", world.last_touch, simulator::kNoPlayer, soccer::kPlayersOnPitch - 1);
  ranges.check("catcher", world.catcher, simulator::kNoPlayer, soccer::kPlayersOnPitch - 1);

  ranges.check("ball_x", world.ball_x, -kMaxPosition, kMaxPosition);
  ranges.check("ball_y", world.ball_y, -kMaxPosition, kMaxPosition);
  ranges.check("ball_vx", world.ball_vx, -kMaxSpeed, kMaxSpeed);
  ranges.check("ball_vy", world.ball_vy, -kMaxSpeed, kMaxSpeed);
  if (!ranges.error.empty()) return Error{std::move(ranges.error)};

  out.cycles = world.cycle;
  out.time = world.time;
  out.score = {world.score[0], world.score[1]};
  out.last_touch = world.last_touch;
  out.catcher = world.catcher;
  return {};
}

}  // namespace

void fill_view(const Episode& episode, cls_training_world& out) {
  const simulator::World& world = episode.world();
  out.seed = episode.seed();
  out.cycle = episode.cycles();
  out.time = world.clock.time;
  out.score[0] = episode.score()[0];
  out.score[1] = episode.score()[1];
  out.status = static_cast<std::int32_t>(episode.status());

  const std::string_view mode = soccer::name(world.mode);
  std::memset(out.play_mode, 0, sizeof out.play_mode);
  std::memcpy(out.play_mode, mode.data(), std::min(mode.size(), sizeof out.play_mode - 1));

  out.ball_x = world.ball.position.x;
  out.ball_y = world.ball.position.y;
  out.ball_vx = world.ball.velocity.x;
  out.ball_vy = world.ball.velocity.y;

  out.last_touch = world.referee.touch.toucher;
  out.catcher = world.ball_catcher;

  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    out.players[slot] = to_player(world, world.player(slot));
  }
}

Result<Start> read_start(const cls_training_world& world, const Setup& setup) {
  Start start;
  TRY_INIT(start.mode, read_mode(world, setup));
  TRY(read_world(world, setup, start));

  StartFrame& frame = start.frames.emplace_back();
  frame.ball = {world.ball_x, world.ball_y};
  frame.ball_velocity = {world.ball_vx, world.ball_vy};
  for (const Side side : soccer::kBothSides) {
    for (const int slot : setup.cast.team(side)) {
      TRY_INIT(frame.players[base::index(slot)],
               read_player(world.players[slot], slot, *setup.prepared.rules));
    }
  }
  return start;
}

}  // namespace cls::training
