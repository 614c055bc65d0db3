// Follows the value of the moment from each decision to the next one.
#include "review/losses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/play/pitch_areas.h"
#include "base/confidence.h"
#include "base/index.h"
#include "review/state_value.h"
#include "soccer/geometry.h"

namespace cls::review {
namespace {

using analysis::Flow;
using soccer::Side;

bool is_pressed(const StateView& view, Side side) {
  for (std::size_t slot = 0; slot < view.players.size(); ++slot) {
    if (view.on_pitch[slot] && soccer::side_of_slot(static_cast<int>(slot)) != side &&
        soccer::distance(view.players[slot], view.ball) < kPressedRange) {
      return true;
    }
  }
  return false;
}

std::string name_of(const Decision& decision, const StateView& view, Side side) {
  return fmt::format("{} in {}{}", kDecisionNames.name(decision.kind),
                     analysis::third_name(soccer::sign(side) * view.ball.x),
                     is_pressed(view, side) ? ", pressed" : "");
}

}  // namespace

std::vector<Loss> losses_of(const analysis::MatchStatistics& match,
                            const std::vector<Decision>& decisions, Side side) {
  const Flow& flow = match.flow;
  std::vector<Loss> losses;
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    const Decision& decision = decisions[i];
    const std::size_t next =
        i + 1 < decisions.size() ? decisions[i + 1].frame : flow.record->frames();
    losses.push_back({name_of(decision, view_of(flow, decision.frame), side), decision.cycle,
                      decision.before - value_after(flow, decision.frame, next, side)});
  }
  return losses;
}

std::vector<LossClass> classes_of(const std::vector<std::vector<Loss>>& losses) {
  struct Sums {
    LossClass sum;
    double squares = 0.0;
    double most = 0.0;
  };
  std::map<std::string, Sums> classes;
  for (std::size_t match = 0; match < losses.size(); ++match) {
    for (const Loss& loss : losses[match]) {
      auto& [sum, squares, most] = classes[loss.name];
      sum.name = loss.name;
      ++sum.decisions;
      sum.goals.value += loss.goals;
      squares += loss.goals * loss.goals;
      if (sum.decisions > 1 && loss.goals <= most) continue;
      most = loss.goals;
      sum.worst = {match, loss.cycle};
    }
  }

  std::vector<LossClass> sorted;
  for (auto& [name, entry] : classes) {
    Estimate& goals = entry.sum.goals;
    const double half = base::kNormal95 * std::sqrt(entry.squares);
    goals.low = goals.value - half;
    goals.high = goals.value + half;
    sorted.push_back(entry.sum);
  }
  std::ranges::stable_sort(sorted, std::ranges::greater{},
                           [](const LossClass& one) { return one.goals.value; });
  return sorted;
}

}  // namespace cls::review
