// Passes: who to whom, how far, and what became of the others.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "analysis/play/flow.h"
#include "analysis/play/shots.h"
#include "soccer/geometry.h"

namespace cls::analysis {

enum class PassOutcome : std::uint8_t {
  kCompleted,
  kIntercepted,  ///< an opponent touched next
  kContested,    ///< both teams at once
  kOut,
  kOffside,
  kStopped,  ///< a foul, another stoppage, or the end of the record
};
std::string_view name(PassOutcome outcome);

/// Directions between the contact points, in sectors of 90 degrees.
enum class PassDirection : std::uint8_t { kForward, kLeft, kRight, kBack };

/// A touch meant for a team mate (match-statistics 2). Points as the passer's team sees the pitch:
/// it attacks +x.
struct Pass {
  std::uint32_t touch = 0;  ///< index into Flow::touches
  std::int8_t passer = kNobody;
  std::int8_t receiver = kNobody;  ///< who touched next: a mate, an interceptor, or nobody
  PassOutcome outcome = PassOutcome::kStopped;
  PassDirection direction = PassDirection::kForward;
  soccer::Vec2 from;
  soccer::Vec2 to;                ///< contact of the next touch, or where the ball was at the end
  std::uint32_t frames = 0;       ///< from touch to touch
  double speed = 0.0;             ///< at launch, metres per cycle
  double nearest_opponent = 0.0;  ///< metres from the receiver at reception; completed only
  int overtaken = 0;              ///< opponents it left behind; completed only
  bool through = false;           ///< received behind the offside line of the launch
  bool cross = false;
  bool switched = false;  ///< long and from one side to the other
  bool cutback = false;
  bool clearance = false;  ///< just away from the own goal

  bool completed() const { return outcome == PassOutcome::kCompleted; }
  double length() const { return soccer::distance(from, to); }
  double gain() const { return to.x - from.x; }
};

/// In the order of the match. What a team mate touches next is a completed pass, however short;
/// other touches are attempts if the ball left with 0.6 m/cycle or went 3 m, and no shot.
std::vector<Pass> passes_of(const Flow& flow, const std::vector<Shot>& shots);

/// Passes p to q to p within 40 cycles, p at least 5 m further forward: per team.
PerTeam<int> one_twos(const Flow& flow, const std::vector<Pass>& passes);

}  // namespace cls::analysis
