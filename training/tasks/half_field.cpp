// Half field offense and defense with the rules of HFO.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "soccer/math.h"
#include "soccer/pitch.h"
#include "training/tasks/task.h"

namespace cls::training {
namespace {

using soccer::math::kPi;

constexpr int kTrialTime = 1000;  // cycles; a trial ends when more have passed
constexpr int kTurnover = 2;      // cycles of possession by the defense
constexpr std::size_t kDifficulty = 0;
constexpr std::size_t kOnBall = 1;
constexpr std::size_t kMinBallX = 2;
constexpr std::size_t kMaxBallX = 3;
constexpr std::size_t kMinBallY = 4;
constexpr std::size_t kMaxBallY = 5;
constexpr std::size_t kUntouched = 6;

std::vector<TaskOption> options() {
  return {
      {"difficulty", 1, 0, 1, "0: ball and attackers start together near the goal; 1: as in HFO"},
      {"offense_on_ball", 0, 0, 11,
       "0: no player; k: the k-th attacker by number starts at the ball, a random one if there is "
       "no k-th"},
      {"min_ball_x", 0, 0, 1, "start of the ball, share of the half's length"},
      {"max_ball_x", 0.2, 0, 1, "same"},
      {"min_ball_y", -0.8, -1, 1, "start of the ball, share of half the width"},
      {"max_ball_y", 0.8, -1, 1, "same"},
      {"untouched_time", 100, 0, 100000, "cycles without a player at the ball; 0: no limit"}};
}

Vec2 place_ball(const Placing& start) {
  const OptionValues& o = start.options;
  const double x = start.random.uniform(o[kMinBallX], std::max(o[kMinBallX], o[kMaxBallX]));
  const double y = start.random.uniform(o[kMinBallY], std::max(o[kMinBallY], o[kMaxBallY]));
  const double d = o[kDifficulty];
  const Vec2 ball = {by_difficulty(d, 42.0, x * soccer::kHalfLength),
                     by_difficulty(d, y * 10.0, y * soccer::kHalfWidth)};
  start.put_ball(ball);
  return ball;
}

// Index of the attacker at the ball; -1: none.
int on_ball(const Placing& start) {
  const int wanted = static_cast<int>(std::lround(start.options[kOnBall]));
  const int attackers = static_cast<int>(start.cast.left.size());
  return wanted > attackers ? start.random.integer(attackers) : wanted - 1;
}

// One of HFO's ten squares around the ball for each attacker, without repetition.
void place_attackers(const Placing& start, Vec2 ball) {
  constexpr double kSquare = 0.1 * soccer::kPitchLength;
  std::array<Vec2, 10> squares = {
      {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}, {0, 2}, {0, -2}, {-2, -2}, {-2, 2}, {2, 2}, {2, -2}}};
  start.random.shuffle(std::span<Vec2>(squares));

  const int chosen = on_ball(start);
  std::array<int, soccer::kPlayersPerTeam> slots{};  // by number, as HFO counts them
  const auto end = std::ranges::copy(start.cast.left, slots.begin()).out;
  std::sort(slots.begin(), end);
  const double spread = by_difficulty(start.options[kDifficulty], 0.2, 1.0);

  for (std::size_t i = 0; i < start.cast.left.size(); ++i) {
    const Vec2 square = squares[i];
    const Vec2 place = {ball.x + spread * kSquare * (start.random.unit() + square.x),
                        ball.y + spread * kSquare * (start.random.unit() + square.y)};
    const double body = start.random.uniform(-kPi, kPi);
    const Vec2 position = {
        std::clamp(place.x, -0.1, soccer::kHalfLength),
        std::clamp(place.y, -0.8 * soccer::kHalfWidth, 0.8 * soccer::kHalfWidth)};

    const bool at_ball = static_cast<int>(i) == chosen;
    start.put(slots[i], at_ball ? Vec2{ball.x - 0.1, ball.y} : position, body);
  }
}

void place_defenders(const Placing& start) {
  for (const int slot : start.cast.right) {
    if (start.world.player(slot).goalie) {
      start.put(slot, {soccer::kHalfLength, 0.0}, kPi);
      continue;
    }
    const double x = start.random.uniform(0.8, 1.0) * soccer::kHalfLength;
    const double y = start.random.uniform(-0.8, 0.8) * soccer::kHalfWidth;
    start.put(slot, {x, y}, kPi);
  }
}

void place(const Placing& start) {
  const Vec2 ball = place_ball(start);
  place_attackers(start, ball);
  place_defenders(start);
}

bool in_area(Vec2 point) {
  return point.x >= 0.0 && point.x <= soccer::kHalfLength &&
         std::fabs(point.y) <= soccer::kHalfWidth;
}

// The order of the checks is HFO's: area and possession are those of the cycle before.
Status judge(const simulator::World& world, const OptionValues& options, TaskMemory& memory) {
  if (scored_against(world, Side::kRight, memory)) {
    ++memory.score[0];
    return Status::kGoal;
  }

  if (!in_area(memory.previous_ball)) return Status::kOutOfBounds;
  if (memory.taken >= kTurnover) return Status::kCaptured;
  if (options[kUntouched] > 0 && memory.untouched > options[kUntouched]) return Status::kOutOfTime;

  count_possession(world, memory);
  const int goalie = soccer::slot_of(Side::kRight, 1);
  return memory.holder == goalie ? Status::kCaptured : Status::kInGame;
}

}  // namespace

Task half_field_offense() {
  return {.id = "HalfFieldOffense",
          .summary = "HFO: attackers against defenders and a goalie in one half",
          .offense = {1, 10, 1},
          .defense = {0, 11, 0},
          .features = "hfo_low",
          .actions = "low",
          .right_goalie = true,
          .half = true,
          .max_cycles = kTrialTime + 1,
          .options = options(),
          .place = place,
          .judge = judge};
}

Task half_field_defense() {
  Task task = half_field_offense();
  task.id = "HalfFieldDefense";
  task.summary = "the same, from the side of the defenders";
  task.defense = {1, 11, 1};
  task.agents = Agents::kRight;
  task.features = "hfo_high";
  task.actions = "hfo";
  return task;
}

}  // namespace cls::training
