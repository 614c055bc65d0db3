// Everything one agent believes about the match: a plain value, filled by proxy/perception.h.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "proxy/formation/formation_set.h"
#include "proxy/world/ball_state.h"
#include "proxy/world/game_state.h"
#include "proxy/world/intercept_table.h"
#include "proxy/world/match_parameters.h"
#include "proxy/world/player_state.h"
#include "proxy/world/self_state.h"
#include "proxy/world/tracker_state.h"
#include "soccer/protocol/team_name.h"

namespace cls::proxy {

/// A message heard from another player or a coach, as it came; decoding is the receiver's matter.
struct HeardMessage {
  GameTime time;
  soccer::Side side = soccer::Side::kNeutral;
  int unum = 0;                ///< 0: an opponent, or a coach
  soccer::AngleDeg direction;  ///< global, to the speaker
  bool coach = false;
  std::string text;
};

/// The four lines that order the players of both teams along x (proxy behaviour 3.7).
struct TeamLines {
  double our_defense = 0.0;    ///< our last line, ball included
  double their_defense = 0.0;  ///< theirs
  double our_defense_players = 0.0;
  double their_defense_players = 0.0;
  double offside = 0.0;  ///< where our attackers become offside
  int offside_count = kNever;
};

/// The believed author of the last kick.
struct LastKick {
  soccer::Side side = soccer::Side::kNeutral;  ///< neutral: undecidable
  int unum = 0;                                ///< 0: not known
};

/// Coordinates: the own team attacks +x whatever its side, so the same code serves both; `Side`
/// values are always the server's. Plain and copyable; the same messages in the same order give
/// the same bits. Derived parts (table, lines, kickable flags, probabilities) hold after
/// `complete()` of perception.h.
struct WorldModel {
  // Who we are.
  soccer::Side our_side = soccer::Side::kLeft;
  int unum = 0;
  bool goalie = false;    ///< connected as goalie
  bool sideline = false;  ///< a coach or trainer: `self` means nothing, all of ours are teammates
  soccer::TeamName our_team_name;
  soccer::TeamName their_team_name;                   ///< empty until somebody of theirs was seen
  std::shared_ptr<const MatchParameters> parameters;  ///< never null
  std::shared_ptr<const FormationSet> formations;     ///< never null

  GameState game;
  SelfState self;
  BallState ball;
  PlayerList teammates;  ///< without the agent itself
  PlayerList opponents;
  PlayerList unknowns;  ///< team not known
  InterceptTable intercept;
  TeamLines lines;
  LastKick last_kick;
  int kickable_teammate_id = 0;  ///< PlayerState::id; 0: none
  int kickable_opponent_id = 0;
  int our_goalie_unum = 0;  ///< 0: not known
  int their_goalie_unum = 0;
  std::array<int, soccer::kPlayersPerTeam> our_types{};    ///< type id by unum - 1
  std::array<int, soccer::kPlayersPerTeam> their_types{};  ///< -1: changed, to what is not known
  FixedList<HeardMessage, 8> heard;                        ///< of the present moment

  SelfTracker self_tracker;  ///< perception's own memory of the localisation
  BallTracker ball_tracker;
  PlayerList lost;  ///< players whose number is known and whose place is not; perception's own
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

  /// The tracked player with that number; null when there is none.
  const PlayerState* teammate(int number) const;
  const PlayerState* opponent(int number) const;
  /// The tracked player of any list with that id; null when there is none.
  const PlayerState* player_by_id(int id) const;
};

}  // namespace cls::proxy
