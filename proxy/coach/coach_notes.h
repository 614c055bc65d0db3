// What an online coach keeps from cycle to cycle, beside the world it sees.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "proxy/coach/strength_estimate.h"
#include "proxy/coach/type_analysis.h"
#include "proxy/perception/player_types_message.h"
#include "proxy/world/world_model.h"

namespace cls::proxy {

struct CoachNotes {
  TypeAnalysis analysis;      ///< of the opponents
  StrengthEstimate strength;  ///< of the own players

  bool lineup_chosen = false;  ///< the first types were given out
  std::vector<int> used;       ///< by type: players of ours who had it since the kick-off
  int substitutions = 0;       ///< since the kick-off

  TypeIds said_types{};  ///< what the players were told last; at first all have type 0
  int freeforms_said = 0;
};

/// One of our players changed his type.
void note_own_change(CoachNotes& notes, const WorldModel& world, int unum, int type);

/// Takes in a completed view. Once per decision.
void take_notes(CoachNotes& notes, const WorldModel& world);

/// The server takes freeform messages now, and some are left.
bool may_say_freeform(const WorldModel& world, const CoachNotes& notes);

}  // namespace cls::proxy
