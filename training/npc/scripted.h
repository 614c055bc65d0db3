// Scripted players: teammates and opponents whose actions the caller does not choose.
#pragma once

#include <array>

#include "training/scene/cast.h"
#include "training/skills/positions.h"
#include "training/skills/skills.h"

namespace cls::training {

/// The situation of a team in a cycle, worked out once for all of its players.
struct TeamSituation {
  Marking marking;
  int rival_cycles = 0;  ///< until the opponent nearest to the ball reaches it
  Seat first = kNoSeat;  ///< own fielder who reaches the ball first
  bool theirs = false;   ///< that opponent is at the ball before the nearest own player
  std::array<Meeting, soccer::kPlayersPerTeam> meetings;  ///< by own seat, of the cast

  /// The opponent nearest to the ball; kNoSeat if there is none.
  Seat rival() const { return marking.holder; }
  const Meeting& meeting_of(Seat own) const { return meetings[static_cast<std::size_t>(own)]; }
};
TeamSituation assess(const Scene& scene, const Cast& cast);

/// A player of the team that attacks, defends or keeps goal, whatever the situation asks for. A
/// pure function of the scene, from which `now` was made.
PlayerCommand scripted_command(const PointOfView& view, const TeamSituation& now);

}  // namespace cls::training
