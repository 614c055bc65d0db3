// Groups kicks to decisions, and values them by what followed.
#include "review/decisions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "base/index.h"
#include "review/state_value.h"

namespace cls::review {
namespace {

using analysis::Flow;
using analysis::MatchStatistics;
using analysis::Touch;
using soccer::Side;

constexpr std::uint32_t kSequence = 2;  // frames between kicks of one decision, at most

// Names the kicks of a match by what the statistics take them for.
class Kinds {
 public:
  explicit Kinds(const MatchStatistics& match)
      : kinds_(match.flow.touches.size(), DecisionKind::kOther),
        receivers_(kinds_.size(), soccer::kNoPlayer) {
    for (const analysis::Carry& carry : match.carries) kinds_[carry.touch] = DecisionKind::kDribble;
    for (const analysis::Pass& pass : match.passes) {
      kinds_[pass.touch] = pass.clearance ? DecisionKind::kClearance : DecisionKind::kPass;
      receivers_[pass.touch] = pass.receiver;
    }
    for (const analysis::Shot& shot : match.shots) kinds_[shot.touch] = DecisionKind::kShot;
  }

  void name(std::size_t touch, Decision& decision) const {
    decision.kind = kinds_[touch];
    decision.receiver = receivers_[touch];
  }

 private:
  std::vector<DecisionKind> kinds_;
  std::vector<int> receivers_;
};

bool continues(const Touch& last, const Touch& next) {
  return next.slot == last.slot && next.kind == analysis::TouchKind::kKick &&
         next.live_phase == last.live_phase && next.frame - last.frame <= kSequence;
}

}  // namespace

double value_after(const Flow& flow, std::size_t frame, std::size_t last, Side side) {
  const gamelog::MatchRecord& record = *flow.record;
  const std::size_t begin = frame;
  while (frame < last && frame + 1 < record.frames() &&
         record.time[frame] < record.time[begin] + kDecisionHorizon) {
    ++frame;
    const int goals = lead_at(record, frame) - lead_at(record, begin);
    if (goals != 0) return std::clamp(goals * soccer::sign(side), -1, 1);
  }
  return state_value(view_of(flow, frame), side);
}

std::vector<Decision> find_decisions(const MatchStatistics& match, Side side) {
  const Flow& flow = match.flow;
  const gamelog::MatchRecord& record = *flow.record;
  const Kinds kinds(match);
  std::vector<Decision> decisions;

  for (std::size_t first = 0, next = 0; first < flow.touches.size(); first = next) {
    const Touch& touch = flow.touches[first];
    next = first + 1;
    if (touch.contested() || touch.kind != analysis::TouchKind::kKick || touch.frame == 0 ||
        touch.live_phase < 0 || analysis::side_of(touch.slot) != side ||
        !flow.is_live(touch.frame - 1)) {
      continue;
    }

    while (next < flow.touches.size() && continues(flow.touches[next - 1], flow.touches[next])) {
      ++next;
    }

    Decision decision;
    decision.frame = touch.frame - 1;
    decision.end = flow.touches[next - 1].frame;
    decision.cycle = record.time[decision.frame];
    decision.slot = touch.slot;
    kinds.name(next - 1, decision);
    decision.before = state_value(view_of(flow, decision.frame), side);
    decision.after = value_after(flow, decision.frame, record.frames(), side);
    decisions.push_back(decision);
  }

  return decisions;
}

std::vector<Decision> costliest(std::vector<Decision> decisions, std::size_t count) {
  std::ranges::stable_sort(decisions, std::ranges::greater{}, &Decision::lost);

  std::vector<Decision> chosen;
  for (const Decision& decision : decisions) {
    if (chosen.size() == count) break;
    const bool near = std::ranges::any_of(chosen, [&](const Decision& other) {
      return std::abs(other.cycle - decision.cycle) < kDecisionHorizon;
    });
    if (!near) chosen.push_back(decision);
  }
  return chosen;
}

std::string text_of(const Decision& decision) {
  const std::string kind(kDecisionNames.name(decision.kind));
  if (decision.kind != DecisionKind::kPass || decision.receiver == soccer::kNoPlayer) return kind;
  return fmt::format("{} to {}{}", kind,
                     analysis::same_team(decision.slot, decision.receiver) ? "" : "their ",
                     soccer::unum_of_slot(decision.receiver));
}

}  // namespace cls::review
