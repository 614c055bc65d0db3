// Figures of moments, their weights, and the fit.
#include "review/state_value.h"

#include <algorithm>
#include <utility>

#include "analysis/situations/linear_system.h"
#include "base/index.h"
#include "soccer/math.h"
#include "soccer/pitch.h"

namespace cls::review {
namespace {

using analysis::dot;
using analysis::Flow;
using analysis::solve;
using soccer::Side;
using soccer::Vec2;

constexpr double kCloseRange = 40.0;
constexpr std::size_t kStride = 10;  // frames between moments of a fit
constexpr std::size_t kCount = kStateFigures.size();

// `cls book fit` on the matches of docs/review.md, in the order of kStateFigures.
constexpr StateFigures kWeights = {-4.123, 0.483, 2.175,  -0.592, 2.084,
                                   0.543,  0.584, -0.022, 1.123};

double logistic(double x) { return 1.0 / (1.0 + soccer::math::exp(-x)); }

Side owner_of(soccer::PlayMode mode, std::int8_t toucher) {
  if (soccer::is_set_play(mode)) return soccer::side(mode);
  return toucher == soccer::kNoPlayer ? Side::kNeutral : soccer::side_of_slot(toucher);
}

// Calls `see` with both views of moments in live play, and whether that side then scores.
template <typename See>
void for_each_moment(const Flow& flow, See see) {
  const gamelog::MatchRecord& record = *flow.record;
  for (std::size_t frame = 0; frame < record.frames(); frame += kStride) {
    if (!flow.is_live(frame)) continue;
    std::size_t end = frame;
    while (end + 1 < record.frames() && record.time[end] < record.time[frame] + kValueHorizon &&
           lead_at(record, end) == lead_at(record, frame)) {
      ++end;
    }
    const int gained = lead_at(record, end) - lead_at(record, frame);

    const StateView view = view_of(flow, frame);
    for (const Side side : soccer::kBothSides) {
      see(figures_of(view, side), gained * soccer::sign(side) > 0);
    }
  }
}

}  // namespace

StateView view_of(const Flow& flow, std::size_t frame) {
  const gamelog::MatchRecord& record = *flow.record;
  StateView view;
  view.ball = record.ball_position[frame];
  view.ball_velocity = record.ball_velocity[frame];
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::size_t entry = analysis::entry_of(frame, slot);
    view.players[slot] = record.players.position[entry];
    view.on_pitch[slot] = gamelog::is_enabled(record, entry);
  }
  view.owner = owner_of(record.mode[frame], flow.owner[frame]);
  return view;
}

StateView view_of(const simulator::World& world) {
  StateView view;
  view.ball = world.ball.position;
  view.ball_velocity = world.ball.velocity;
  for (std::size_t slot = 0; slot < view.players.size(); ++slot) {
    view.players[slot] = world.players[slot].position;
    view.on_pitch[slot] = world.players[slot].enabled;
  }
  view.owner = owner_of(world.mode, static_cast<std::int8_t>(world.referee.touch.toucher));
  return view;
}

StateFigures figures_of(const StateView& view, Side side) {
  const double sign = soccer::sign(side);
  const double x = sign * view.ball.x;
  const double to_goal = soccer::distance(Vec2{x, view.ball.y}, Vec2{soccer::kHalfLength, 0.0});
  const double close = std::max(0.0, 1.0 - to_goal / kCloseRange);
  const double has = view.owner == side ? 1.0 : 0.0;

  double behind = 0.0;
  double ahead = 0.0;
  for (std::size_t slot = 0; slot < view.players.size(); ++slot) {
    if (!view.on_pitch[slot] || sign * view.players[slot].x <= x) continue;
    const bool own = soccer::side_of_slot(static_cast<int>(slot)) == side;
    (own ? ahead : behind) += 1.0 / soccer::kPlayersPerTeam;
  }

  return {1.0,           has,         x / soccer::kHalfLength,           close,
          close * close, has * close, sign * view.ball_velocity.x / 2.7, behind,
          ahead};
}

const StateFigures& state_weights() { return kWeights; }

double chance_to_score(const StateFigures& figures) { return logistic(dot(kWeights, figures)); }

double chance_to_score(const StateView& view, Side side) {
  return chance_to_score(figures_of(view, side));
}

double state_value(const StateView& view, Side side) {
  return chance_to_score(view, side) - chance_to_score(view, soccer::opponent(side));
}

void StateFitter::add(const Flow& flow) {
  for_each_moment(flow, [&](const StateFigures& figures, bool goal) {
    rows_.push_back({figures, goal});
  });
}

std::size_t StateFitter::goals() const {
  return base::index(std::ranges::count_if(rows_, [](const Row& row) { return row.goal; }));
}

StateFigures StateFitter::fit() const {
  constexpr int kRounds = 30;
  constexpr double kPull = 1.0;
  StateFigures weights{};

  for (int round = 0; round < kRounds; ++round) {
    StateFigures slope{};
    analysis::Matrix<kCount> curvature{};
    for (std::size_t i = 0; i < kCount; ++i) {
      slope[i] = -kPull * weights[i];
      curvature[i][i] = kPull;
    }

    for (const Row& row : rows_) {
      const double chance = logistic(dot(weights, row.figures));
      const double error = (row.goal ? 1.0 : 0.0) - chance;
      for (std::size_t i = 0; i < kCount; ++i) {
        slope[i] += error * row.figures[i];
        const double scaled = chance * (1.0 - chance) * row.figures[i];
        for (std::size_t k = 0; k < kCount; ++k) curvature[i][k] += scaled * row.figures[k];
      }
    }

    const StateFigures step = solve(curvature, slope);
    for (std::size_t i = 0; i < kCount; ++i) weights[i] += step[i];
  }

  return weights;
}

std::vector<CalibrationBin> StateFitter::calibration(std::size_t count) const {
  std::vector<std::pair<double, bool>> rows;  // chance, goal
  for (const Row& row : rows_) rows.emplace_back(chance_to_score(row.figures), row.goal);
  std::ranges::stable_sort(rows, {}, &std::pair<double, bool>::first);

  std::vector<CalibrationBin> bins(rows.empty() ? 0 : count);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CalibrationBin& bin = bins[i * count / rows.size()];
    ++bin.moments;
    bin.chance += rows[i].first;
    bin.goals += rows[i].second ? 1.0 : 0.0;
  }

  for (CalibrationBin& bin : bins) {
    if (bin.moments == 0) continue;
    bin.chance /= static_cast<double>(bin.moments);
    bin.goals /= static_cast<double>(bin.moments);
  }
  return bins;
}

}  // namespace cls::review
