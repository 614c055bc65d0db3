// A task: who plays, where, until when, for what reward. Tables of data and two functions.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "base/text/enum_names.h"
#include "simulator/world/world.h"
#include "training/scene/cast.h"

namespace cls::training {

/// How an episode ended. Numbers and names are part of the C interface.
enum class Status : int {
  kInGame = 0,
  kGoal = 1,          ///< the left team scored
  kCaptured = 2,      ///< the right team has the ball
  kOutOfBounds = 3,   ///< the ball left the area of the task
  kOutOfTime = 4,     ///< truncated: too long, or the ball was untouched too long
  kGoalConceded = 5,  ///< the right team scored
  kReached = 6,       ///< the task's aim other than a goal
  kFullTime = 7,      ///< the match is over
  kStopped = 8,       ///< the referee stopped play
};

struct StatusInfo {
  std::string_view name;
  bool truncated;
  std::string_view summary;
};
/// By number.
const std::array<StatusInfo, 9>& statuses();

/// A number that a caller may change between episodes.
struct TaskOption {
  std::string_view name;
  double value;  ///< default
  double low;
  double high;
  std::string_view summary;
};

constexpr std::size_t kMaxOptions = 8;
/// Values by index in Task::options.
using OptionValues = std::array<double, kMaxOptions>;

/// Memory of the rules of a task between cycles.
struct TaskMemory {
  Vec2 previous_ball;
  int cycles = 0;
  int untouched = 0;  ///< cycles since a player could kick the ball
  int taken = 0;      ///< cycles of possession by the right team, as HFO counts them
  int holder = simulator::kNoPlayer;
  std::array<int, 2> score = {};  ///< goals of the episode: left, right
};

/// Places ball and players at the start. All players of the cast are on the pitch already.
struct Placing {
  simulator::World& world;
  const Cast& cast;
  const OptionValues& options;
  soccer::RandomStream& random;

  /// Puts a player down, at rest, facing `body` (radians).
  void put(int slot, Vec2 position, double body) const;
  void put_ball(Vec2 position, Vec2 velocity = {}) const;
};

struct Range {
  int low;
  int high;
  int usual;
};

enum class Agents : unsigned char { kLeft, kRight, kBoth };
constexpr auto kAgentsNames = base::enum_names<Agents>("offense", "defense", "both");

struct Task {
  std::string_view id;
  int version = 0;
  std::string_view summary;
  Range offense{};                ///< players of the left team
  Range defense{};                ///< of the right team, including its goalie
  Agents agents = Agents::kLeft;  ///< default
  std::string_view features = "ego";
  std::string_view actions = "hfo";
  bool referee = false;  ///< the full referee of the soccer server; otherwise only the task's rules
  bool right_goalie = false;  ///< the first player of the right team is its goalie
  bool half = false;          ///< played in the right half of the pitch
  int max_cycles = 0;
  std::vector<TaskOption> options{};
  void (*place)(const Placing& start) = nullptr;
  /// Called after every step; updates the memory.
  Status (*judge)(const simulator::World& world, const OptionValues& options,
                  TaskMemory& memory) = nullptr;
  bool lazy = false;  ///< opponents stand, except their goalie, where "scripted" would play

  Stage stage(Side side) const;
  OptionValues usual_options() const;
};

/// All tasks; "difficulty" is the first option of each.
const std::vector<Task>& tasks();

/// Null for unknown ids.
const Task* find_task(std::string_view id);

/// Slots of a team with so many players of a task, in the order of the arrays.
std::vector<int> team_slots(const Task& task, Side side, int players);

/// Position of a player at a kick-off: in the own half, server coordinates.
Vec2 kick_off_position(int slot);

// Rules that tasks share.

/// True if the ball crossed the goal line of `defender` between the posts in this cycle.
bool scored_against(const simulator::World& world, Side defender, const TaskMemory& memory);

/// Counts cycles, possession and untouched cycles as HFO's referee does.
void count_possession(const simulator::World& world, TaskMemory& memory);

/// Linear from `easy` (difficulty 0) to `usual` (difficulty 1).
double by_difficulty(double difficulty, double easy, double usual);

// One file each.
Task half_field_offense();
Task half_field_defense();
Task keepaway();
Task penalty();
Task reach_ball();
Task match();
std::vector<Task> academy();

}  // namespace cls::training
