// Game state: clock, play mode, score, shoot-out.
#pragma once

#include "player/world/age.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::player {

/// Shoot-out counters (docs/spec/proxy-behavior.md 3.8).
struct PenaltyState {
  soccer::Side field_side = soccer::Side::kNeutral;  ///< side of the goal in use
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
      false;  ///< free kick after a catch: the goalie of the mode's side holds the ball
  soccer::Side caught_side = soccer::Side::kNeutral;  ///< side whose goalie caught the ball last
  int caught_time = -1;                               ///< cycle of that catch; -1: never
  GameTime mode_start;                                ///< when the current mode was announced
  int last_set_play_start = 0;  ///< cycle when a mode other than play_on and penalties began
  int set_play_count = 0;       ///< decisions since then
  int our_score = 0;
  int their_score = 0;
  PenaltyState penalty;

  /// Side named by the mode (for offenses the offender); neutral if none.
  soccer::Side mode_side() const { return soccer::side(mode); }
};

/// True for a set play of `side`, including offenses of the other side.
bool is_set_play_of(const GameState& game, soccer::Side side);

/// True for modes during which the server clock is stopped.
bool clock_stopped(soccer::PlayMode mode);

/// Starts a new step at `cycle`. While the clock is stopped, counts the steps from 1.
void begin_step(GameState& game, int cycle);

/// Default uniform number of the n-th kicker (from 1) of a shoot-out.
int default_penalty_taker(int n);

}  // namespace cls::player
