// The graph of completed passes.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "analysis/measures/threat.h"
#include "analysis/play/passes.h"

namespace cls::analysis {

/// Passes from one player to another (index: uniform number - 1), and their means.
struct PassEdge {
  int passes = 0;
  double length = 0.0;  ///< mean, meters
  double gain = 0.0;    ///< mean, meters forward
  double threat = 0.0;  ///< sum of the added threat (threat.h)
};

/// Graph measures of a player.
struct PassNode {
  int given = 0;  ///< completed passes (weighted out-degree)
  int received = 0;
  int partners = 0;  ///< teammates that exchanged a pass with the player
  double page_rank = 0.0;
  double betweenness = 0.0;   ///< of shortest paths; edge length 1 / passes; 0 to 1
  double clustering = 0.0;    ///< share of pairs of partners that exchanged a pass
  soccer::Vec2 mean_contact;  ///< of the given passes, as the team sees the pitch
};

struct PassNetwork {
  std::array<std::array<PassEdge, kTeamSize>, kTeamSize> edges = {};  ///< [from][to]
  std::array<PassNode, kTeamSize> nodes = {};
  int passes = 0;
  double density = 0.0;   ///< share of the 110 possible edges that are used
  double top_edge = 0.0;  ///< share of the most used edge
  double entropy = 0.0;   ///< of the shares of edges, in bits
};

/// The network of one team.
PassNetwork pass_network(const std::vector<Pass>& passes, const ThreatGrid& grid, std::size_t team);

}  // namespace cls::analysis
