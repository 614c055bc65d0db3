// Figures of a situation and their weights.
#include "analysis/situations/situation_value.h"

#include <algorithm>

#include "analysis/measures/expected_goals.h"
#include "analysis/play/shots.h"
#include "soccer/pitch.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

constexpr double kDangerRange = 40.0;

// `cls book fit` on the matches of docs/tournaments.md, in the order of kFigureNames.
constexpr std::array<double, kFigureNames.size()> kWeights = {3.69, 7.01, 2.38, 1.48,
                                                              4.92, 2.04, 0.89, 4.32};

// Goals a match for the value that windows of whole matches have: a situation lasts too short a
// time for the better team to get all of its advantage (docs/tournaments.md).
constexpr double kSituationScale = 4.0;

double sign_of(std::int8_t slot) { return slot == kNoPlayer ? 0.0 : attack_sign(slot); }

double closeness(Vec2 ball, double goal_x) {
  return std::max(0.0, 1.0 - soccer::distance(ball, Vec2{goal_x, 0.0}) / kDangerRange);
}

double danger(Vec2 ball) {
  return closeness(ball, soccer::kHalfLength) - closeness(ball, -soccer::kHalfLength);
}

}  // namespace

SituationFigures figures_of(const Flow& flow, std::size_t begin, std::size_t end) {
  const gamelog::MatchRecord& record = *flow.record;
  SituationFigures figures;
  const int lead = lead_at(record, begin);
  std::size_t last = begin;

  for (std::size_t frame = begin; frame < end && figures.goals == 0.0; ++frame) {
    last = frame;
    figures.mean_ball_x += record.ball_position[frame].x / soccer::kHalfLength;
    figures.mean_possession += sign_of(flow.owner[frame]);
    figures.mean_danger += danger(record.ball_position[frame]);
    figures.goals = std::clamp(lead_at(record, frame) - lead, -1, 1);
  }

  const auto count = static_cast<double>(last - begin + 1);
  figures.mean_ball_x /= count;
  figures.mean_possession /= count;
  figures.mean_danger /= count;

  for (const Shot& shot : find_shots(flow)) {
    const std::size_t frame = flow.touches[shot.touch].frame;
    if (frame <= begin || frame > last) continue;
    figures.expected_goals += sign_of(shot.slot) * goal_probability(situation_of(flow, shot));
  }
  if (figures.goals != 0.0) return figures;

  const Vec2 ball = record.ball_position[last];
  figures.end_ball_x = ball.x / soccer::kHalfLength;
  figures.end_possession = sign_of(flow.owner[last]);
  figures.end_danger = danger(ball);
  return figures;
}

double situation_value(const SituationFigures& figures) {
  double value = 0.0;
  const auto values = figures.values();
  for (std::size_t i = 0; i < values.size(); ++i) value += kWeights[i] * values[i];
  return kSituationScale * value;
}

const std::array<double, 8>& situation_weights() { return kWeights; }

}  // namespace cls::analysis
