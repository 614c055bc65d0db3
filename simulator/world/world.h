// The whole state of a match as one copyable value.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>

#include "simulator/world/player.h"
#include "simulator/world/random_streams.h"
#include "simulator/world/rules.h"
#include "simulator/world/state.h"
#include "soccer/play_mode.h"
#include "soccer/protocol/team_name.h"

namespace cls::simulator {

using soccer::PlayMode;

/// A simulation step is known by both numbers: `stoppage` counts steps in which `time` stands
/// still and is 0 whenever it has just advanced.
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
  soccer::TeamName name;
  bool connected = false;
  int score = 0;
  int penalty_kicks = 0;  ///< taken in the shoot-out
  int penalty_goals = 0;
  bool won_coin_toss = false;
  int substitutions = 0;                       ///< after the first kick-off
  std::array<int, kMaxPlayerTypes> used = {};  ///< how often each type was given since then
};

/// Drawn at the start, turned round at half time (3.2).
struct Wind {
  Vec2 vector;
  double rand = 0.0;
};

enum class FoulCall : std::uint8_t { kNone, kCharge, kYellow, kRed };

/// Where a recorded step took an object, and the noise that explains it.
struct ShownMotion {
  std::optional<Vec2> arrival;  ///< forces the noise, if noise can have done it

  // The step tells:
  Vec2 noise;              ///< of a forced motion; zero if noise cannot explain it
  double noise_max = 0.0;  ///< the noise of motion is drawn from a disc of this radius
  Vec2 expected;           ///< where it would have been without noise
  double reach = 0.0;      ///< how far from there noise, kicks' included, can take it
  bool explained = false;
};

/// Outcomes to take instead of drawing them: how a recorded match is replayed.
struct ForcedOutcomes {
  template <typename T>
  using PerPlayer = std::array<T, soccer::kPlayersOnPitch>;
  using Players = std::bitset<soccer::kPlayersOnPitch>;

  PerPlayer<std::optional<bool>> tackle;      ///< it succeeds
  PerPlayer<std::optional<bool>> catch_ball;  ///< it succeeds
  PerPlayer<std::optional<FoulCall>> foul;    ///< by tackler
  PerPlayer<std::optional<double>> body;      ///< radians, where a turn ends if noise can do it
  PerPlayer<std::optional<Vec2>> placement;   ///< where the referee puts a player at random
  PerPlayer<ShownMotion> players;
  ShownMotion ball;
  std::optional<Side> shoot_out_goal;
  std::optional<Side> first_penalty_taker;

  // What the step would have drawn; kicks and tackles go without noise while outcomes are forced.
  Players tackle_drawn;
  Players catch_drawn;
  Players foul_drawn;
  Players placement_drawn;
  double push_noise_max = 0.0;    ///< sum over what kicks and tackles can add to the ball
  double push_noise_mean2 = 0.0;  ///< mean square of what they add
};

/// Everything that decides how the match goes on: copying it forks the match, and two equal worlds
/// given equal commands stay equal. It holds no client, clock or socket. Change it through
/// actions.h, step.h, referee.h, roster.h, substitution.h and trainer.h.
struct World {
  std::shared_ptr<const Rules> rules;
  std::uint64_t seed = 0;

  Clock clock;
  PlayMode mode = PlayMode::kBeforeKickOff;
  Side kick_off_side = Side::kLeft;  ///< whose set play it is; left's before the first kick-off
  int last_play_on = 0;              ///< when the mode last became play_on

  Ball ball;
  std::array<Player, soccer::kPlayersOnPitch> players;
  std::array<Team, 2> teams;  ///< left, right
  Slot ball_catcher = kNobody;

  Wind wind;
  RefereeState referee;
  AutoMode auto_mode;
  RandomStreams random;
  std::optional<ForcedOutcomes> forced;

  const soccer::ServerParams& params() const { return rules->server; }
  Player& player(Side side, int unum) {
    return players[static_cast<std::size_t>(soccer::slot_of(side, unum))];
  }
  const Player& player(Side side, int unum) const {
    return players[static_cast<std::size_t>(soccer::slot_of(side, unum))];
  }
  Player& player(Slot slot) { return players[static_cast<std::size_t>(slot)]; }
  const Player& player(Slot slot) const { return players[static_cast<std::size_t>(slot)]; }
  const soccer::PlayerType& type_of(const Player& who) const {
    return rules->types[static_cast<std::size_t>(who.type)];
  }
  Team& team(Side side) { return teams[side == Side::kRight ? 1 : 0]; }
  const Team& team(Side side) const { return teams[side == Side::kRight ? 1 : 0]; }
};

/// A match before anybody has connected: time 0, before_kick_off, all players on the bench.
World make_world(std::shared_ptr<const Rules> rules, std::uint64_t seed);

/// Where a player stands who is not on the pitch yet or any more (1.5).
Vec2 bench_place(const Player& player);

/// True if the ball is within the player's kickable area.
bool is_kickable(const World& world, const Player& player);

}  // namespace cls::simulator
