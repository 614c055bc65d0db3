// The view of both sides for soccerwindow2.
#pragma once

#include "match/hooks/side_hooks.h"
#include "proxy/agent/debug_client.h"

namespace cls::match {

/// Passes the decisions of a side to a proxy::DebugClient.
class DebugClientOfSide : public SideDecisions {
 public:
  explicit DebugClientOfSide(const proxy::DebugOptions& options) : client_(options) {}

  void on_decision(const proxy::Decision& decision) override { client_.on_decision(decision); }

  /// Writes the rest of the files. Returns the error, or an empty string.
  std::string close() { return client_.close(); }

 private:
  proxy::DebugClient client_;
};

class DebugClients : public SideHooks<DebugClientOfSide> {
 public:
  explicit DebugClients(const proxy::DebugOptions& options)
      : SideHooks({DebugClientOfSide(options), DebugClientOfSide(options)}) {}
};

}  // namespace cls::match
