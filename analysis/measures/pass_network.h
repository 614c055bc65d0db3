// Who plays with whom: the graph of completed passes.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "analysis/measures/threat.h"
#include "analysis/play/passes.h"

namespace cls::analysis {

constexpr std::size_t kTeamSize = gamelog::kSlots / 2;

/// Passes from a player to another (by number - 1), and their means.
struct PassEdge {
  int passes = 0;
  double length = 0.0;  ///< mean metres
  double gain = 0.0;    ///< mean metres forward
  double threat = 0.0;  ///< sum of what they added (threat.h)
};

/// A player's place in the graph.
struct PassNode {
  int given = 0;  ///< completed passes (weighted out-degree)
  int received = 0;
  int partners = 0;  ///< mates he exchanged a pass with
  double page_rank = 0.0;
  double betweenness = 0.0;   ///< share of shortest paths over him, way = 1 / passes; 0 to 1
  double clustering = 0.0;    ///< share of pairs of his partners that exchanged a pass
  soccer::Vec2 mean_contact;  ///< of the passes he gave, as the team sees the pitch
};

struct PassNetwork {
  std::array<std::array<PassEdge, kTeamSize>, kTeamSize> edges = {};  ///< [from][to]
  std::array<PassNode, kTeamSize> nodes = {};
  int passes = 0;
  double density = 0.0;   ///< used edges of all 110
  double top_edge = 0.0;  ///< share of the most used edge
  double entropy = 0.0;   ///< of the shares of edges, bits
};

/// The network of one team.
PassNetwork pass_network(const std::vector<Pass>& passes, const ThreatGrid& grid, std::size_t team);

}  // namespace cls::analysis
