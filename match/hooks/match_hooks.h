// Hooks into a running match: scenarios, recorders, `--step`.
#pragma once

#include <optional>
#include <string>

#include "match/result/match_observer.h"
#include "match/sides/match_side.h"
#include "simulator/world/event.h"
#include "simulator/world/world.h"
#include "soccer/geometry.h"
#include "soccer/side.h"

namespace cls::match {

/// The match after a step.
struct MatchView {
  MatchProgress progress;
  int stoppage = 0;                         ///< steps since the clock stopped; embedded server only
  std::optional<soccer::Vec2> ball;         ///< nothing: unknown
  const simulator::World* world = nullptr;  ///< embedded server in lockstep only
};

/// All functions are called on the match's thread, except those of a listener.
class MatchHooks {
 public:
  virtual ~MatchHooks() = default;

  /// Hears all calls of a side with a Playmaker, on any server; nullptr: none.
  virtual SideListener* listener(soccer::Side /*side*/) { return nullptr; }

  /// All agents are connected and registered, and no cycle has been played: the world may be
  /// changed like by a trainer. In lockstep only.
  virtual void arrange(simulator::World& /*world*/, simulator::Events& /*events*/) {}

  /// After every step, before players perceive it: the world may be changed like by a trainer. In
  /// lockstep only.
  virtual void after_step(simulator::World& /*world*/, simulator::Events& /*events*/) {}

  /// After every step, before the Playmakers are asked about it. May block: the stall limit counts
  /// from its return. In lockstep, and over UDP with MatchOptions::step.
  virtual void before_decisions(const MatchView& /*view*/) {}

  /// After all decisions of the cycle (over UDP: after they were allowed). False ends the match as
  /// finished.
  virtual bool after_cycle(const MatchView& /*view*/) { return true; }
};

/// Hooks of a match with a folder, which have a say in its result.
class FolderHooks : public MatchHooks {
 public:
  /// After the match: adds what only the hooks know.
  virtual void add_result(MatchResult& /*result*/) const {}
  /// Why the match is refused after all, or an empty string.
  virtual std::string problem() const { return {}; }
  /// Completes the files. Returns the first error, or an empty string.
  virtual std::string close() { return {}; }
};

}  // namespace cls::match
