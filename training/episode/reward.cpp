// The terms of rewards.
#include "training/episode/reward.h"

#include <algorithm>

#include "base/index.h"
#include "soccer/pitch.h"

namespace cls::training {
namespace {

enum Term : std::size_t {
  kGoal,
  kCaptured,
  kOutOfBounds,
  kOutOfTime,
  kReached,
  kPossession,
  kAdvance,
  kCheckpoints,
  kApproach,
  kFirstTouch,
  kEffort
};

constexpr Vec2 kRightGoal = {soccer::kHalfLength, 0.0};
// Longer than the way between any two places; the referee moves ball and players within a cycle.
constexpr double kMaxDistance = 150.0;
constexpr int kRings = 10;
constexpr double kOuterRing = 0.99 * soccer::kPitchLength;
constexpr double kInnerRing = 0.20 * soccer::kHalfLength;

// Rings around the right goal that the ball has reached.
int rings_reached(double distance) {
  int reached = 0;
  for (int i = 0; i < kRings; ++i) {
    const double radius = kOuterRing + (kInnerRing - kOuterRing) * i / (kRings - 1);
    reached += distance <= radius ? 1 : 0;
  }
  return reached;
}

// Terms of the left team; those of the right team have the other sign.
RewardValues team_values(const simulator::World& world, Status status, const TaskMemory& task,
                         std::array<int, 2> before, RewardMemory& memory) {
  RewardValues values = {};
  values[kGoal] = (task.score[0] - before[0]) - (task.score[1] - before[1]);
  values[kCaptured] = status == Status::kCaptured ? -1.0 : 0.0;
  values[kOutOfBounds] = status == Status::kOutOfBounds ? -1.0 : 0.0;
  values[kOutOfTime] = status == Status::kOutOfTime ? -1.0 : 0.0;
  values[kReached] = status == Status::kReached ? 1.0 : 0.0;

  if (task.holder != simulator::kNoPlayer) {
    values[kPossession] = soccer::side_of_slot(task.holder) == Side::kLeft ? 1.0 : -1.0;
  }

  const double to_right = distance(world.ball.position, kRightGoal);
  values[kAdvance] = memory.ball_to_right_goal - to_right;
  memory.ball_to_right_goal = to_right;

  // The rest of the rings is paid at the goal.
  const bool ours = values[kPossession] > 0.0;
  int rings = ours ? std::max(memory.rings, rings_reached(to_right)) : memory.rings;
  if (values[kGoal] > 0.0) rings = kRings;
  values[kCheckpoints] = 0.1 * (rings - memory.rings);
  memory.rings = rings;

  return values;
}

}  // namespace

const std::array<RewardTerm, kRewardTerms>& reward_terms() {
  static const std::array<RewardTerm, kRewardTerms> all = {
      {{"goal", 1, "goals", -1, 1, "1 for a goal of the own team, -1 for one of the others"},
       {"captured", 0, "1", -1, 1,
        "-1 for the left team when the defense wins the ball, 1 for the right"},
       {"out_of_bounds", 0, "1", -1, 1,
        "-1 for the left team when the ball leaves the area, 1 for the right"},
       {"out_of_time", 0, "1", -1, 1, "-1 for the left team when time runs out, 1 for the right"},
       {"reached", 1, "1", -1, 1, "1 when the aim of the task is reached"},
       {"possession", 0, "cycles", -1, 1,
        "1 for each cycle in which the own team had the ball last, -1 else"},
       {"advance", 0, "m", -kMaxDistance, kMaxDistance,
        "meters that the ball came nearer to the goal that the left team attacks; "
        "negative for the right team"},
       {"checkpoints", 0, "1", -1, 1,
        "0.1 for each of ten rings around the goal that the left team's ball "
        "enters; the rest with a goal; negative for the right team"},
       {"approach", 0, "m", -kMaxDistance, kMaxDistance,
        "meters that the agent came nearer to the ball"},
       {"first_touch", 0, "1", 0, 1, "1 when the agent can kick the ball for the first time"},
       {"effort", 0, "dashes", -1, 0, "-1 for a dash with full power, less for weaker ones"}}};
  return all;
}

void begin_rewards(const simulator::World& world, const Cast& cast, RewardMemory& memory) {
  memory = {};
  memory.ball_to_right_goal = distance(world.ball.position, kRightGoal);
  for (const int slot : cast.agents) {
    const auto i = base::index(slot);
    memory.to_ball[i] = distance(world.player(slot).position, world.ball.position);
    memory.touched[i] = simulator::is_kickable(world, world.player(slot));
  }
}

void add_rewards(const simulator::World& world, const Cast& cast, Status status,
                 const TaskMemory& task, std::array<int, 2> before, RewardMemory& memory,
                 std::array<RewardValues, soccer::kPlayersOnPitch>& sums) {
  const RewardValues team = team_values(world, status, task, before, memory);

  for (std::size_t agent = 0; agent < cast.agents.size(); ++agent) {
    const int slot = cast.agents[agent];
    const auto i = base::index(slot);
    const simulator::Player& player = world.player(slot);
    RewardValues& sum = sums[agent];
    const double sign = soccer::sign(player.side);

    for (std::size_t term = 0; term <= kCheckpoints; ++term) sum[term] += sign * team[term];
    if (!player.enabled) continue;

    const double to_ball = distance(player.position, world.ball.position);
    sum[kApproach] += memory.to_ball[i] - to_ball;
    memory.to_ball[i] = to_ball;

    if (!memory.touched[i] && simulator::is_kickable(world, player)) {
      memory.touched[i] = true;
      sum[kFirstTouch] += 1.0;
    }
  }
}

void add_effort(double power, RewardValues& sum) {
  sum[kEffort] -= std::clamp(power < 0.0 ? -power : power, 0.0, 100.0) / 100.0;
}

}  // namespace cls::training
