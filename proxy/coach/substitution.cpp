// Initial types, and substitutions of tired players.
#include "proxy/coach/substitution.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "base/index.h"
#include "player/world/planner_parameters.h"

namespace cls::proxy {
namespace {

using Commands = std::vector<soccer::CoachCommand>;

// Steps before the kick-off to wait until all players are connected.
constexpr int kMinStoppedSteps = 10;
constexpr int kLastCycles = 500;
constexpr double kTired = 0.002;  // recovery lost
// Order in which players get the fastest remaining type; the goalie is skipped.
using Order = std::array<int, soccer::kPlayersPerTeam>;
constexpr Order kUsualOrder = {11, 2, 3, 10, 9, 6, 4, 5, 7, 8, 1};
constexpr Order kFastBacksOrder = {4, 5, 2, 3, 11, 10, 9, 6, 7, 8, 1};

/// Remaining uses of each type.
using Pool = std::vector<int>;

// Stamina per cycle at top speed, minus the recovery per cycle.
double cost_of_top_speed(const soccer::ServerParams& server, const soccer::PlayerType& type) {
  const double push = player::top_speed(server, type) * (1.0 - type.player_decay);
  return push / (type.dash_power_rate * type.effort_max) - type.stamina_inc_max;
}

// -1 when the pool is empty.
int fastest(const player::MatchParameters& parameters, const Pool& pool) {
  constexpr double kAlike = 0.01;  // meters per cycle
  const auto speed = [&](int id) {
    return player::top_speed(parameters.server, parameters.type(id));
  };
  // Less is better.
  const auto rank = [&](int id) {
    const soccer::PlayerType& type = parameters.type(id);
    return std::pair(player::cycles_to_top_speed(parameters.server, type),
                     cost_of_top_speed(parameters.server, type));
  };

  double best_speed = 0.0;
  for (int id = 0; id < std::ssize(pool); ++id) {
    if (pool[base::index(id)] > 0) best_speed = std::max(best_speed, speed(id));
  }

  int best = -1;
  for (int id = 0; id < std::ssize(pool); ++id) {
    if (pool[base::index(id)] <= 0 || speed(id) < best_speed - kAlike) continue;
    if (best < 0 || rank(id) < rank(best)) best = id;
  }
  return best;
}

Pool whole_pool(const soccer::PlayerParams& params) {
  Pool pool(base::index(params.player_types), params.pt_max);
  if (params.allow_mult_default_type) pool[0] = soccer::kPlayersPerTeam + 1;
  return pool;
}

void choose_lineup(const player::WorldModel& world, Commands& out) {
  const player::MatchParameters& parameters = *world.parameters;
  Pool pool = whole_pool(parameters.player);
  const int goalie = world.our_goalie_unum != 0 ? world.our_goalie_unum : 1;
  if (world.teammate(goalie) != nullptr) out.push_back(soccer::ChangePlayerType{goalie, 0});
  --pool[0];

  for (const int unum : world.planner->fast_backs != 0 ? kFastBacksOrder : kUsualOrder) {
    if (unum == goalie || world.teammate(unum) == nullptr) continue;
    const int type = fastest(parameters, pool);
    if (type < 0) return;
    --pool[base::index(type)];
    out.push_back(soccer::ChangePlayerType{unum, type});
  }
}

std::vector<int> tired_players(const player::WorldModel& world, const CoachMemory& memory) {
  std::vector<int> tired;
  for (const player::PlayerState& teammate : world.teammates) {
    const double recovery = memory.stamina.of(teammate.unum).recovery;
    if (recovery < world.server().recover_init - kTired) tired.push_back(teammate.unum);
  }
  std::ranges::stable_sort(tired, {}, [&](int unum) { return memory.stamina.of(unum).recovery; });
  return tired;
}

void replace_tired(const player::WorldModel& world, const CoachMemory& memory, Commands& out) {
  const player::MatchParameters& parameters = *world.parameters;
  Pool pool = whole_pool(parameters.player);

  for (std::size_t id = 0; id < pool.size() && id < memory.used.size(); ++id) {
    pool[id] -= memory.used[id];
  }

  int left = parameters.player.subs_max - memory.substitutions;
  for (const int unum : tired_players(world, memory)) {
    const int type = fastest(parameters, pool);
    if (left-- <= 0 || type < 0) return;
    --pool[base::index(type)];
    out.push_back(soccer::ChangePlayerType{unum, type});
  }
}

bool is_stoppage(const player::WorldModel& world) {
  const soccer::PlayMode mode = world.game.mode;
  return mode != soccer::PlayMode::kPlayOn && mode != soccer::PlayMode::kTimeOver &&
         !soccer::is_penalty_mode(mode);
}

}  // namespace

void substitute(const player::WorldModel& world, CoachMemory& memory, Commands& out) {
  const player::GameTime now = world.game.time;
  if (now.cycle <= 0) {
    if (now.stopped <= kMinStoppedSteps || memory.lineup_chosen) return;
    memory.lineup_chosen = true;
    choose_lineup(world, out);
    return;
  }

  const int end = world.server().normal_time_cycles();
  // The coach substitutes only in normal time.
  if (end <= 0 || now.cycle < end - kLastCycles || !is_stoppage(world)) return;
  if (now.cycle >= world.server().total_time_cycles()) return;
  replace_tired(world, memory, out);
}

}  // namespace cls::proxy
