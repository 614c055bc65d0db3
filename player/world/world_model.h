// The world model of one agent: a plain value, updated by player/perception/perception.h.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "player/formation/formation_set.h"
#include "player/world/ball_state.h"
#include "player/world/game_state.h"
#include "player/world/gaussian.h"
#include "player/world/intercept_table.h"
#include "player/world/match_parameters.h"
#include "player/world/player_state.h"
#include "player/world/self_state.h"
#include "soccer/commands/player_command.h"
#include "soccer/protocol/team_name.h"

namespace cls::player {

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
  GameTime time;
  soccer::Side side = soccer::Side::kNeutral;
  int unum = 0;                ///< 0: an opponent, or a coach
  soccer::AngleDeg direction;  ///< global, to the speaker
  bool coach = false;
  std::string text;
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
  soccer::Side side = soccer::Side::kNeutral;  ///< neutral: ambiguous
  int unum = 0;                                ///< 0: unknown
};

/// Coordinates: the own team attacks +x on both sides; `Side` values are the server's. Plain and
/// copyable; the same messages in the same order give the same bits. update_derived() sets the
/// derived parts (intercept table, lines, kickable flags, probabilities).
struct WorldModel {
  // Identity.
  soccer::Side our_side = soccer::Side::kLeft;
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
  soccer::Side their_side() const { return soccer::opponent(our_side); }
  bool kickable_teammate() const { return kickable_teammate_id != 0; }
  bool kickable_opponent() const { return kickable_opponent_id != 0; }

  /// Tracked player by uniform number; null if none.
  const PlayerState* teammate(int number) const;
  const PlayerState* opponent(int number) const;
  /// Tracked player of any list by id; null if none.
  const PlayerState* player_by_id(int id) const;
};

}  // namespace cls::player
