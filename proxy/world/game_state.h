// The match around the agent: clock, play mode, score, shoot-out.
#pragma once

#include "proxy/world/age.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::proxy {

/// Shoot-out counters (proxy behaviour 3.8).
struct PenaltyState {
  soccer::Side field_side = soccer::Side::kNeutral;  ///< where the goal in use stands
  soccer::Side taker = soccer::Side::kNeutral;
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
  soccer::PlayMode mode = soccer::PlayMode::kBeforeKickOff;
  bool goalie_catch =
      false;  ///< the mode's side plays a free kick because its goalie holds the ball
  soccer::Side caught_side = soccer::Side::kNeutral;  ///< whose goalie caught the ball last
  int caught_time = -1;                               ///< and when; -1: never
  GameTime mode_start;                                ///< when the present mode was announced
  int last_set_play_start = 0;  ///< cycle when a mode other than play_on and penalties began
  int set_play_count = 0;       ///< decisions since then
  int our_score = 0;
  int their_score = 0;
  PenaltyState penalty;

  /// The side attached to the mode (for offences the offender); neutral if none.
  soccer::Side mode_side() const { return soccer::side(mode); }
};

/// A dead ball that `side` is to play, offences of the other side included.
bool is_set_play_of(const GameState& game, soccer::Side side);

/// Modes during which the server's clock stands.
bool clock_stands(soccer::PlayMode mode);

/// A new moment at that cycle. While the clock stands, moments are counted: the first one that
/// stands is number 1.
void open_moment(GameState& game, int cycle);

/// The number that takes the n-th (from 1) kick of a shoot-out when nobody decides otherwise.
int default_penalty_taker(int n);

}  // namespace cls::proxy
