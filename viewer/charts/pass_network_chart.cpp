// Circles at mean positions; lines as wide as the pair's share of the most frequent one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viewer/charts/layout.h"

namespace cls::viewer {
namespace {

using Node = PassNetworkData::Node;
using Edge = PassNetworkData::Edge;

// Pairs with fewer passes are left out where others have more.
constexpr int kMinPasses = 3;

int shown_passes(const std::vector<Edge>& edges) {
  int most = 0;
  for (const Edge& edge : edges) most = std::max(most, edge.passes);
  return std::clamp(most, 1, kMinPasses);
}

void draw_edges(Drawing& drawing, const PitchPlace& place, const PassNetworkData& data) {
  constexpr double kWidest = 9.0;
  std::vector<Edge> edges = data.edges;
  std::ranges::stable_sort(edges, {}, &Edge::passes);

  const int shown = shown_passes(edges);
  for (const Edge& edge : edges) {
    const bool known = edge.first < data.nodes.size() && edge.second < data.nodes.size();
    if (!known || edge.passes < shown) continue;

    const double share = static_cast<double>(edge.passes) / edges.back().passes;
    drawing.line(place.at(data.nodes[edge.first].position),
                 place.at(data.nodes[edge.second].position),
                 {line_of(data.tone), std::max(1.2, kWidest * share), 0.3 + 0.4 * share});
  }
}

void draw_nodes(Drawing& drawing, const PitchPlace& place, const PassNetworkData& data) {
  constexpr double kMinRadius = 9.0;  // room for the number
  constexpr double kMaxRadius = 19.0;
  int most = 1;
  for (const Node& node : data.nodes) most = std::max(most, node.passes);

  for (const Node& node : data.nodes) {
    const soccer::Vec2 center = place.at(node.position);
    const double share = static_cast<double>(std::max(0, node.passes)) / most;
    const double radius = std::max(kMinRadius, kMaxRadius * std::sqrt(share));
    drawing.circle(center, radius, {fill_of(data.tone)},
                   fmt::format("player {}: {} passes given and received", node.unum, node.passes));
    drawing.circle(center, radius, {"ring", 1.5});
    drawing.text(center + soccer::Vec2{0.0, 4.0}, fmt::to_string(node.unum), "unum on",
                 Anchor::kMiddle);
  }
}

}  // namespace

std::string pass_network_chart(const PassNetworkData& data) {
  constexpr double kTop = 34.0;
  constexpr double kBelow = 28.0;

  Drawing drawing = titled_drawing(data.title, height_with_pitch(kTop, kBelow));
  const PitchPlace place = draw_pitch(drawing, kTop);
  draw_edges(drawing, place, data);
  draw_nodes(drawing, place, data);

  const int shown = shown_passes(data.edges);
  drawing.text({kChartMargin, place.bottom() + 18},
               data.nodes.empty() ? "no completed pass"
                                  : fmt::format("circle area: passes given and received; lines: "
                                                "pairs with {} or more passes",
                                                shown),
               "soft");
  return std::move(drawing).finish();
}

}  // namespace cls::viewer
