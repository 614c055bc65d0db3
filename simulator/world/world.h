// Complete state of a match as one copyable value.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

#include "base/boxed.h"
#include "simulator/world/player.h"
#include "simulator/world/referee_state.h"
#include "simulator/world/replay_overrides.h"
#include "simulator/world/rules.h"
#include "soccer/play_mode.h"
#include "soccer/protocol/team_name.h"
#include "soccer/random.h"

namespace cls::simulator {

using soccer::PlayMode;
using soccer::RandomStream;
using PlayerStreams = std::array<RandomStream, soccer::kPlayersOnPitch>;

/// One random stream per purpose, so that a draw for one purpose never shifts another: the streams
/// of the simulation itself. The server derives its own streams (order of commands, senses)
/// from World::seed.
struct RandomStreams {
  explicit RandomStreams(std::uint64_t seed = 0);

  RandomStream ball_motion;
  PlayerStreams player_motion;
  PlayerStreams turn;  ///< turns, and rotation by dashes
  PlayerStreams kick_noise;
  PlayerStreams tackle;  ///< success
  PlayerStreams tackle_noise;
  PlayerStreams catch_ball;
  PlayerStreams foul;      ///< indexed by tackler
  RandomStream collision;  ///< directions for objects at the same position
  RandomStream placement;  ///< random positions chosen by the referee
  RandomStream shoot_out;  ///< goal, first taker, coin toss
};

/// Identifies a simulation step: `stoppage` counts the steps with a stopped clock since `time`
/// advanced.
struct Clock {
  int time = 0;
  int stoppage = 0;

  friend constexpr bool operator==(Clock a, Clock b) {
    return a.time == b.time && a.stoppage == b.stoppage;
  }
};

struct Ball {
  Vec2 position;
  Vec2 velocity;
  Vec2 acceleration;
};

struct Team {
  soccer::TeamName name;      ///< unique in the match
  soccer::TeamName own_name;  ///< as its clients call it, if another team has that name
  bool connected = false;
  int score = 0;
  int penalty_kicks = 0;  ///< penalty kicks taken in the shoot-out
  int penalty_goals = 0;
  bool won_coin_toss = false;
  int substitutions = 0;                       ///< after the first kick-off
  std::array<int, kMaxPlayerTypes> used = {};  ///< assignments of each player type since then
};

/// Drawn at the start, reversed at half time (docs/spec/simulation-model.md 3.2).
struct Wind {
  Vec2 vector;
  double rand = 0.0;
};

/// Complete simulation state. A copy forks the match, and equal worlds given equal commands stay
/// equal. Contains no client, wall clock or socket. Change it through actions.h, step.h, referee.h,
/// roster.h, substitution.h and trainer.h.
struct World {
  std::shared_ptr<const Rules> rules;
  std::uint64_t seed = 0;

  Clock clock;
  PlayMode mode = PlayMode::kBeforeKickOff;
  Side kick_off_side = Side::kLeft;  ///< side of the set play; left before the first kick-off
  int last_play_on = 0;              ///< time at which the mode last became play_on

  Ball ball;
  std::array<Player, soccer::kPlayersOnPitch> players;
  std::array<Team, 2> teams;  ///< left, right
  Slot ball_catcher = kNoPlayer;

  Wind wind;
  RefereeState referee;
  AutoMode auto_mode;
  RandomStreams random;
  base::Boxed<ReplayOverrides> overrides;  ///< set during log replay only

  const soccer::ServerParams& params() const { return rules->server; }
  Player& player(Side side, int unum) {
    return players[static_cast<std::size_t>(soccer::slot_of(side, unum))];
  }
  const Player& player(Side side, int unum) const {
    return players[static_cast<std::size_t>(soccer::slot_of(side, unum))];
  }
  Player& player(Slot slot) { return players[static_cast<std::size_t>(slot)]; }
  const Player& player(Slot slot) const { return players[static_cast<std::size_t>(slot)]; }
  const soccer::PlayerType& type_of(const Player& player) const {
    return rules->types[static_cast<std::size_t>(player.type)];
  }
  Team& team(Side side) { return teams[side == Side::kRight ? 1 : 0]; }
  const Team& team(Side side) const { return teams[side == Side::kRight ? 1 : 0]; }
};

/// World of a new match: time 0, before_kick_off, all players on the bench.
World make_world(std::shared_ptr<const Rules> rules, std::uint64_t seed);

/// Stream for draws outside the simulation, such as the order of commands and the noise of senses.
/// Keyed by seed, purpose, clock and player, so that connections do not shift draws of other
/// clients.
RandomStream clock_stream(const World& world, std::string_view purpose, Slot slot);

/// Position of a player that is not on the pitch (docs/spec/simulation-model.md 1.5).
Vec2 bench_position(const Player& player);

/// True if the ball is within the player's kickable area.
bool is_kickable(const World& world, const Player& player);

}  // namespace cls::simulator
