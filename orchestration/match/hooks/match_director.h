// Who arranges a match by hand and watches it from inside: scenarios, recorders, a debugger's
// steps.
#pragma once

#include "proxy/playmaker/rpc_listener.h"
#include "simulator/world/event.h"
#include "simulator/world/world.h"
#include "soccer/side.h"

namespace cls::orchestration::match {

/// Every function has a harmless default. All are called from the match's thread except what a
/// listener hears, which comes from its side's.
class MatchDirector {
 public:
  virtual ~MatchDirector() = default;

  /// Hears all calls of that side; null: nobody does.
  virtual proxy::RpcListener* listener(soccer::Side /*side*/) { return nullptr; }

  /// Everybody is connected and introduced, no cycle is played: the world may be changed as a
  /// trainer could.
  virtual void arrange(simulator::World& /*world*/, simulator::Events& /*events*/) {}

  /// After every step, before the Playmakers are asked about it. May wait: the stall limit counts
  /// from its return.
  virtual void before_decisions(const simulator::World& /*world*/) {}

  /// After every cycle, all answers are in. False ends the match, as finished.
  virtual bool after_cycle(const simulator::World& /*world*/) { return true; }
};

}  // namespace cls::orchestration::match
