// Graph measures on eleven nodes.
#include "analysis/measures/pass_network.h"

#include <algorithm>
#include <limits>

#include "soccer/math.h"

namespace cls::analysis {
namespace {

constexpr double kDamping = 0.85;
constexpr int kPageRankRounds = 50;
constexpr double kFar = std::numeric_limits<double>::infinity();

void add_passes(const std::vector<Pass>& passes, const ThreatGrid& grid, std::size_t team,
                PassNetwork& network) {
  for (const Pass& pass : passes) {
    const auto passer = slot_index(pass.passer);
    if (!pass.completed() || team_of(passer) != team) continue;

    const std::size_t from = passer % kTeamSize;
    const std::size_t to = slot_index(pass.receiver) % kTeamSize;

    PassEdge& edge = network.edges[from][to];
    ++edge.passes;
    edge.length += pass.length();
    edge.gain += pass.gain();
    edge.threat += grid[threat_cell(pass.to)] - grid[threat_cell(pass.from)];
    ++network.nodes[from].given;
    ++network.nodes[to].received;
    network.nodes[from].mean_contact += pass.from;
    ++network.passes;
  }

  for (auto& row : network.edges) {
    for (PassEdge& edge : row) {
      if (edge.passes == 0) continue;
      edge.length /= edge.passes;
      edge.gain /= edge.passes;
    }
  }

  for (PassNode& node : network.nodes) {
    if (node.given > 0) node.mean_contact = node.mean_contact / node.given;
  }
}

bool exchanged(const PassNetwork& network, std::size_t a, std::size_t b) {
  return network.edges[a][b].passes + network.edges[b][a].passes > 0;
}

void set_partners(PassNetwork& network) {
  for (std::size_t i = 0; i < kTeamSize; ++i) {
    std::vector<std::size_t> partners;
    for (std::size_t j = 0; j < kTeamSize; ++j) {
      if (j != i && exchanged(network, i, j)) partners.push_back(j);
    }

    int pairs = 0;
    int linked = 0;
    for (std::size_t a = 0; a < partners.size(); ++a) {
      for (std::size_t b = a + 1; b < partners.size(); ++b) {
        ++pairs;
        linked += exchanged(network, partners[a], partners[b]);
      }
    }

    network.nodes[i].partners = static_cast<int>(partners.size());
    network.nodes[i].clustering = pairs == 0 ? 0.0 : static_cast<double>(linked) / pairs;
  }
}

// A player without passes distributes its rank evenly.
void set_page_rank(PassNetwork& network) {
  std::array<double, kTeamSize> rank;
  rank.fill(1.0 / kTeamSize);

  for (int round = 0; round < kPageRankRounds; ++round) {
    std::array<double, kTeamSize> next;
    double spread = 1.0 - kDamping;
    for (std::size_t i = 0; i < kTeamSize; ++i) {
      if (network.nodes[i].given == 0) spread += kDamping * rank[i];
    }
    next.fill(spread / kTeamSize);

    for (std::size_t from = 0; from < kTeamSize; ++from) {
      for (std::size_t to = 0; to < kTeamSize; ++to) {
        const int passes = network.edges[from][to].passes;
        if (passes > 0) next[to] += kDamping * rank[from] * passes / network.nodes[from].given;
      }
    }
    rank = next;
  }

  for (std::size_t i = 0; i < kTeamSize; ++i) network.nodes[i].page_rank = rank[i];
}

struct Paths {
  std::array<std::array<double, kTeamSize>, kTeamSize> length;
  std::array<std::array<double, kTeamSize>, kTeamSize> count;  ///< of shortest ones
};

// Floyd-Warshall with path counts; lengths are compared with a tolerance.
Paths shortest_paths(const PassNetwork& network) {
  constexpr double kSame = 1e-12;
  Paths paths;

  for (std::size_t i = 0; i < kTeamSize; ++i) {
    for (std::size_t j = 0; j < kTeamSize; ++j) {
      const int passes = network.edges[i][j].passes;
      paths.length[i][j] = passes > 0 && i != j ? 1.0 / passes : kFar;
      paths.count[i][j] = passes > 0 && i != j ? 1.0 : 0.0;
    }
  }

  for (std::size_t k = 0; k < kTeamSize; ++k) {
    for (std::size_t i = 0; i < kTeamSize; ++i) {
      for (std::size_t j = 0; j < kTeamSize; ++j) {
        if (i == j || i == k || j == k) continue;
        const double over = paths.length[i][k] + paths.length[k][j];
        if (over < paths.length[i][j] - kSame) {
          paths.length[i][j] = over;
          paths.count[i][j] = paths.count[i][k] * paths.count[k][j];
        } else if (over < kFar && over <= paths.length[i][j] + kSame) {
          paths.count[i][j] += paths.count[i][k] * paths.count[k][j];
        }
      }
    }
  }
  return paths;
}

void set_betweenness(PassNetwork& network) {
  constexpr double kPairs = (kTeamSize - 1) * (kTeamSize - 2);
  const Paths paths = shortest_paths(network);

  for (std::size_t k = 0; k < kTeamSize; ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < kTeamSize; ++i) {
      for (std::size_t j = 0; j < kTeamSize; ++j) {
        if (i == j || i == k || j == k || paths.length[i][j] == kFar) continue;
        const double over = paths.length[i][k] + paths.length[k][j];
        if (over > paths.length[i][j] + 1e-9) continue;
        sum += paths.count[i][k] * paths.count[k][j] / paths.count[i][j];
      }
    }
    network.nodes[k].betweenness = sum / kPairs;
  }
}

void set_totals(PassNetwork& network) {
  constexpr double kAllEdges = kTeamSize * (kTeamSize - 1);
  int used = 0;

  for (const auto& row : network.edges) {
    for (const PassEdge& edge : row) {
      if (edge.passes == 0) continue;
      ++used;
      const double share = static_cast<double>(edge.passes) / network.passes;
      network.top_edge = std::max(network.top_edge, share);
      network.entropy -= share * soccer::math::log(share) / soccer::math::log(2.0);
    }
  }

  network.density = used / kAllEdges;
}

}  // namespace

PassNetwork pass_network(const std::vector<Pass>& passes, const ThreatGrid& grid,
                         std::size_t team) {
  PassNetwork network;
  add_passes(passes, grid, team, network);
  set_partners(network);
  set_page_rank(network);
  set_betweenness(network);
  set_totals(network);
  return network;
}

}  // namespace cls::analysis
