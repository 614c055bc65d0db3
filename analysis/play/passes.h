// Passes: passer, receiver, distance and outcome.
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
  kContested,    ///< both teams touched next
  kOut,
  kOffside,
  kStopped,  ///< a foul, another stoppage, or the end of the record
};
std::string_view name(PassOutcome outcome);

/// Directions between the contact points, in sectors of 90 degrees.
enum class PassDirection : std::uint8_t { kForward, kLeft, kRight, kBack };

/// A touch intended for a teammate (docs/spec/match-statistics.md 2). Points as the passer's team
/// sees the pitch: it attacks +x.
struct Pass {
  std::uint32_t touch = 0;  ///< index into Flow::touches
  std::int8_t passer = kNoPlayer;
  std::int8_t receiver = kNoPlayer;  ///< next toucher: teammate, interceptor or none
  PassOutcome outcome = PassOutcome::kStopped;
  PassDirection direction = PassDirection::kForward;
  soccer::Vec2 from{};
  soccer::Vec2 to{};  ///< contact point of the next touch, or position of the ball at the stoppage
  std::uint32_t frames = 0;       ///< from touch to touch
  double speed = 0.0;             ///< at launch, meters per cycle
  double nearest_opponent = 0.0;  ///< meters from the receiver at reception; completed passes only
  int overtaken = 0;              ///< opponents overtaken; completed passes only
  bool through = false;           ///< received beyond the offside line at launch
  bool cross = false;
  bool switched = false;  ///< long, from one side to the other
  bool cutback = false;
  bool clearance = false;  ///< hit away from the own goal

  bool completed() const { return outcome == PassOutcome::kCompleted; }
  double length() const { return soccer::distance(from, to); }
  double gain() const { return to.x - from.x; }
};

/// In the order of the match. A pass is completed if a teammate touches next, at any length. Other
/// touches are attempts if the ball left with 0.6 m/cycle or moved 3 m, and they are not shots.
std::vector<Pass> find_passes(const Flow& flow, const std::vector<Shot>& shots);

/// Number per team of passes p to q to p within 40 cycles, with p at least 5 m further forward.
PerTeam<int> one_twos(const Flow& flow, const std::vector<Pass>& passes);

/// Offside line of a frame, as the attacking team sees the pitch: x of the second last connected
/// opponent, goalie included; at least that of the ball and the half line.
double offside_line(const gamelog::MatchRecord& record, std::size_t frame,
                    std::size_t attacking_team);

}  // namespace cls::analysis
