// The world model of one agent: a plain value, updated by player/perception/perception.h.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "base/fixed_list.h"
#include "player/formation/formation_set.h"
#include "player/world/age.h"
#include "player/world/gaussian.h"
#include "player/world/match_parameters.h"
#include "player/world/object_states.h"
#include "player/world/vocabulary.h"
#include "soccer/commands/player_command.h"
#include "soccer/protocol/team_name.h"

namespace cls::player {

/// Shoot-out counters (docs/spec/proxy-behavior.md 3.8).
struct PenaltyState {
  Side field_side = Side::kNeutral;  ///< side of the goal in use
  Side taker = Side::kNeutral;
  int our_taken = 0;
  int their_taken = 0;
  int our_score = 0;
  int their_score = 0;
  int cycle = 0;  ///< start of the last setup, ready or taken mode
};

struct GameState {
  GameTime time;
  int see_time = -1;  ///< cycle of the last see; -1: none yet
  GameTime last_see;  ///< the same with the stop counter
  PlayMode mode = PlayMode::kBeforeKickOff;
  bool goalie_catch =
      false;  ///< free kick after a catch: the goalie of the mode's side holds the ball
  Side caught_side = Side::kNeutral;  ///< side whose goalie caught the ball last
  int caught_time = -1;               ///< cycle of that catch; -1: never
  GameTime mode_start;                ///< when the current mode was announced
  int last_set_play_start = 0;        ///< cycle when a mode other than play_on and penalties began
  int set_play_count = 0;             ///< decisions since then
  int our_score = 0;
  int their_score = 0;
  PenaltyState penalty;

  /// Side named by the mode (for offenses the offender); neutral if none.
  Side mode_side() const { return soccer::side(mode); }
};

/// True for a set play of `side`, including offenses of the other side.
bool is_set_play_of(const GameState& game, Side side);

/// True before a kick-off, and after a goal: players may move to their places.
bool before_play(PlayMode mode);

/// True for modes during which the server clock is stopped.
bool clock_stopped(PlayMode mode);

/// Starts a new step at `cycle`. While the clock is stopped, counts the steps from 1.
void begin_step(GameState& game, int cycle);

/// Default uniform number of the n-th kicker (from 1) of a shoot-out.
int default_penalty_taker(int n);

/// One way for the agent to intercept the ball: turns, then dashes. Without turns, the first dash
/// may turn the body by `turn_angle` (leg_turn() with `dash_power`).
struct InterceptPlan {
  enum class Kind : std::uint8_t { kOmniDash, kTurnForwardDash, kTurnBackwardDash };

  Kind kind = Kind::kOmniDash;
  int turns = 0;
  int dashes = 0;
  bool leg_turn = false;        ///< the first dash turns the body
  bool exhausting = false;      ///< drops stamina below the threshold where recovery decreases
  double turn_angle = 0.0;      ///< total, degrees, relative to the body
  double dash_power = 0.0;      ///< of the first dash
  double dash_direction = 0.0;  ///< degrees relative to the body after turning
  Vec2 self_position;           ///< own position at the end
  double ball_distance = 0.0;   ///< to the ball at the end
  double stamina = 0.0;         ///< left at the end

  int steps() const { return turns + dashes; }
};

constexpr std::size_t kMaxInterceptPlans = 64;

/// Steps are cycles from now; kNever: cannot reach it, or unknown. Ids are PlayerState::id; 0:
/// none.
struct InterceptTable {
  int self_steps = kNever;             ///< of the fastest non-exhausting plan
  int self_exhausting_steps = kNever;  ///< of the fastest exhausting plan
  int first_teammate_steps = kNever;
  int second_teammate_steps = kNever;
  int first_opponent_steps = kNever;
  int second_opponent_steps = kNever;
  int first_teammate_id = 0;
  int second_teammate_id = 0;
  int first_opponent_id = 0;
  int second_opponent_id = 0;
  base::FixedList<InterceptPlan, kMaxInterceptPlans> plans;  ///< by steps, ascending

  /// Minimum over exhausting and other plans.
  int best_self_steps() const {
    return self_steps < self_exhausting_steps ? self_steps : self_exhausting_steps;
  }
  /// Of the agent or its fastest teammate.
  int our_steps() const {
    return first_teammate_steps < best_self_steps() ? first_teammate_steps : best_self_steps();
  }
};

struct PlannerParameters;

/// Commands sent in the previous cycle; at most one of each kind.
struct SentCommands {
  std::optional<soccer::Turn> turn;
  std::optional<soccer::Dash> dash;
  std::optional<soccer::Kick> kick;
  std::optional<soccer::Tackle> tackle;
  std::optional<soccer::Catch> catches;
  std::optional<soccer::Move> move;
  std::optional<soccer::TurnNeck> turn_neck;
  std::optional<soccer::PointTo> point_to;
  std::optional<soccer::LegDash> leg_dash;
};

/// Estimate of (x, y, body in degrees), and the sent commands not yet confirmed.
struct SelfTracker {
  bool located = false;  ///< the pose is valid
  Gaussian<3> pose;
  double heading_variance = 0.0;  ///< of the direction of the agent's velocity, square degrees
  double heading_follows_body =
      0.0;  ///< degrees the velocity direction turns per degree of body correction
  SentCommands sent;
};

/// Estimate of the ball's (x, y, vx, vy).
struct BallTracker {
  bool tracked = false;
  bool pushed =
      false;  ///< the current see message contradicts the predicted path: a player touched the ball
  Gaussian<4> state;
};

/// A say message heard from a player or coach, not decoded.
struct HeardMessage {
  GameTime time{};
  Side side = Side::kNeutral;
  int unum = 0;          ///< 0: an opponent, or a coach
  AngleDeg direction{};  ///< global, to the speaker
  bool coach = false;
  std::string text{};
};

/// Defense and offside lines (docs/spec/proxy-behavior.md 3.7).
struct TeamLines {
  double our_defense = 0.0;    ///< our defense line, including the ball
  double their_defense = 0.0;  ///< their defense line, including the ball
  double our_defense_players = 0.0;
  double their_defense_players = 0.0;
  double offside = 0.0;  ///< offside line for our attackers
  int offside_count = kNever;
};

/// Estimated last kicker.
struct LastKick {
  Side side = Side::kNeutral;  ///< neutral: ambiguous
  int unum = 0;                ///< 0: unknown
};

/// Coordinates: the own team attacks +x on both sides; `Side` values are the server's. Plain and
/// copyable; the same messages in the same order give the same bits. update_derived() sets the
/// derived parts (intercept table, lines, kickable flags, probabilities).
struct WorldModel {
  // Identity.
  Side our_side = Side::kLeft;
  int unum = 0;
  bool goalie = false;    ///< connected as goalie
  bool sideline = false;  ///< coach or trainer: `self` is unused, teammates holds the whole team
  bool leg_dashes =
      false;  ///< skills use two-leg dashes, which the server executes since version 19
  soccer::TeamName our_team_name;
  soccer::TeamName their_team_name;                   ///< empty until an opponent was seen
  std::shared_ptr<const MatchParameters> parameters;  ///< not null
  std::shared_ptr<const FormationSet> formations;     ///< not null
  std::shared_ptr<const PlannerParameters> planner;   ///< of the own team; not null

  GameState game;
  SelfState self;
  BallState ball;
  PlayerList teammates;  ///< without the agent
  PlayerList opponents;
  PlayerList unknowns;  ///< unknown team
  InterceptTable intercept;
  TeamLines lines;
  LastKick last_kick;
  int kickable_teammate_id = 0;  ///< PlayerState::id; 0: none
  int kickable_opponent_id = 0;
  int our_goalie_unum = 0;  ///< 0: unknown
  int their_goalie_unum = 0;
  std::array<int, soccer::kPlayersPerTeam> our_types{};    ///< type id by unum - 1
  std::array<int, soccer::kPlayersPerTeam> their_types{};  ///< -1: substituted, type unknown
  base::FixedList<HeardMessage, 8> heard;                  ///< in the current step

  SelfTracker self_tracker;  ///< used by perception only
  BallTracker ball_tracker;
  PlayerList lost;  ///< players of known number and unknown position; used by perception only
  int next_player_id = 1;

  WorldModel();

  const soccer::ServerParams& server() const { return parameters->server; }
  const soccer::PlayerType& self_type() const { return parameters->type(self.type_id); }
  const soccer::PlayerType& type_of(const PlayerState& player) const {
    return parameters->type(player.type_id);
  }
  Side their_side() const { return soccer::opponent(our_side); }
  bool kickable_teammate() const { return kickable_teammate_id != 0; }
  bool kickable_opponent() const { return kickable_opponent_id != 0; }

  /// Tracked player by uniform number; null if none.
  const PlayerState* teammate(int number) const;
  const PlayerState* opponent(int number) const;
  /// Tracked player of any list by id; null if none.
  const PlayerState* player_by_id(int id) const;
};

/// True while a goalie of our team holds the ball after a catch.
inline bool holds_caught_ball(const WorldModel& world) {
  return world.game.goalie_catch && world.game.mode_side() == world.our_side;
}

}  // namespace cls::player
