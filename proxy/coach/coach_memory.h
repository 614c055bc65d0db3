// An online coach's memory from cycle to cycle, in addition to the world model.
#pragma once

#include <vector>

#include "player/perception/player_types_message.h"
#include "player/world/world_model.h"
#include "proxy/coach/stamina_estimate.h"
#include "proxy/coach/type_analysis.h"

namespace cls::proxy {

struct CoachMemory {
  TypeAnalysis analysis;    ///< of the opponents
  StaminaEstimate stamina;  ///< of the own players

  bool lineup_chosen = false;  ///< the initial types were assigned
  std::vector<int> used;       ///< by type: own players with it since the kick-off
  int substitutions = 0;       ///< since the kick-off

  player::TypeIds said_types{};  ///< last types sent to the players; initially all 0
  int freeforms_sent = 0;        ///< without refused ones
  player::GameTime said_in;      ///< when the play mode of the last one had begun
  bool said_in_vain = false;     ///< the server refused the last one
};

/// An own player was substituted or changed type.
void record_type_change(CoachMemory& memory, const player::WorldModel& world, int unum, int type);

/// Evaluates a completed view. Once per decision.
void update_memory(CoachMemory& memory, const player::WorldModel& world);

/// The server refused the last types sent, because a kick had started play in the cycle of the
/// message. The players have not heard them; the server does not count them.
void record_refused_types(CoachMemory& memory);

/// True when the types are to be sent: the players do not have them yet. Refused types wait until
/// the play mode has changed; without that the server would refuse them in each cycle.
bool has_types_to_say(const player::WorldModel& world, const CoachMemory& memory);

/// True when the server accepts freeform messages now and the quota is not used up.
bool can_say_freeform(const player::WorldModel& world, const CoachMemory& memory);

}  // namespace cls::proxy
