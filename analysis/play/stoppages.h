// Referee calls: restarts, offsides, fouls, cards.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/play/flow.h"
#include "soccer/play_mode.h"

namespace cls::analysis {

/// Counts of one team: restarts that it takes, offenses that it commits.
struct TeamStoppages {
  int kick_offs = 0;
  int kick_ins = 0;
  int corners = 0;
  int goal_kicks = 0;
  int free_kicks = 0;  ///< except after the own goalie's catch
  int indirect_free_kicks = 0;
  int goalie_catches = 0;
  int offsides = 0;
  int fouls = 0;  ///< charge and push
  int back_passes = 0;
  int free_kick_faults = 0;
  int catch_faults = 0;
  int illegal_defenses = 0;
  int yellow_cards = 0;
  int red_cards = 0;
  int restart_frames = 0;  ///< until the ball was played

  int set_plays() const {
    return kick_offs + kick_ins + corners + goal_kicks + free_kicks + indirect_free_kicks;
  }

  friend bool operator==(const TeamStoppages&, const TeamStoppages&) = default;
};

struct Foul {
  std::uint32_t frame = 0;
  soccer::PlayMode mode = soccer::PlayMode::kNull;
  std::int8_t fouler = kNoPlayer;
  std::int8_t victim = kNoPlayer;
};

struct Stoppages {
  PerTeam<TeamStoppages> teams = {};
  std::vector<Foul> fouls;
  PerPlayer<int> fouls_by = {};
  PerPlayer<int> fouls_against = {};
  PerPlayer<int> yellow_cards = {};
  PerPlayer<int> red_cards = {};
};

/// Counts by the play modes of frames: a mode that begins and ends between two frames is missed.
/// Shoot-outs are excluded.
Stoppages count_stoppages(const Flow& flow);

}  // namespace cls::analysis
