// What each player of a team estimated, received and sent, as the stream of the decision debugger
// (docs/formats/decisions.md).
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "proxy/agent/decision_listener.h"
#include "soccer/side.h"
#include "viewer/decisions/decision_writer.h"

namespace cls::match {

/// Texts and drawings of a team beyond this are left out.
constexpr std::size_t kMaxDrawings = std::size_t{64} << 20;

/// Hears the decisions of a side, and appends complete chunks to `out`. In lockstep the same match
/// gives the same decisions, in the same order; their latencies differ. Without decisions there is
/// no stream.
class DecisionStream : public proxy::DecisionListener {
 public:
  DecisionStream(soccer::Side side, std::string team) : side_(side), team_(std::move(team)) {}

  void on_decision(const proxy::Decision& decision) override;
  void end_cycle(std::string& out);
  /// Called last.
  void end(std::string& out);

 private:
  soccer::Side side_;
  std::string team_;
  bool begun_ = false;
  viewer::DecisionWriter writer_;
  std::array<std::vector<viewer::DecisionSample>, soccer::kPlayersPerTeam> waiting_;
  std::size_t room_ = kMaxDrawings;
};

}  // namespace cls::match
