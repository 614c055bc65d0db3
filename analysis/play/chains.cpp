// Splits touches into possession chains.
#include "analysis/play/chains.h"

#include <algorithm>

#include "analysis/play/pitch_areas.h"
#include "base/text/enum_names.h"

namespace cls::analysis {
namespace {

constexpr auto kResultNames =
    base::enum_names<ChainResult>("goal", "shot", "box_entry", "lost", "out");
constexpr int kAssistCycles = 60;

bool continues(const Touch& next, const Chain& chain, const Touch& last) {
  return !next.contested() && next.live_phase == last.live_phase &&
         team_of(next.slot) == chain.team;
}

class ChainClassifier {
 public:
  ChainClassifier(const Flow& flow, const std::vector<Pass>& passes, const std::vector<Shot>& shots)
      : flow_(flow), passes_(passes), shots_(shots) {}

  void judge(Chain& chain) {
    const Touch& first = flow_.touches[chain.first_touch];
    const Touch& last = flow_.touches[chain.last_touch];
    const double sign = chain.team == 0 ? 1.0 : -1.0;

    chain.frames = last.frame - first.frame;
    chain.from = first.contact * sign;
    chain.to = last.contact * sign;
    chain.from_set_play = first.frame > 0 && flow_.phase[first.frame - 1] == Phase::kSet;

    for (; pass_ < passes_.size() && passes_[pass_].touch <= chain.last_touch; ++pass_) {
      chain.passes += passes_[pass_].touch >= chain.first_touch && passes_[pass_].completed();
    }
    chain.result = result_of(chain, last, sign);
  }

 private:
  ChainResult result_of(const Chain& chain, const Touch& last, double sign) {
    bool shot = false;
    for (; shot_ < shots_.size() && shots_[shot_].touch <= chain.last_touch; ++shot_) {
      if (shots_[shot_].touch < chain.first_touch) continue;
      if (shots_[shot_].outcome == ShotOutcome::kGoal) return ChainResult::kGoal;
      shot = true;
    }
    if (shot) return ChainResult::kShot;

    const std::size_t next = chain.last_touch + 1;
    const bool touched =
        next < flow_.touches.size() && flow_.touches[next].live_phase == last.live_phase;
    const std::size_t end = touched ? flow_.touches[next].frame : flow_.end_of_play(last);

    for (std::size_t i = flow_.touches[chain.first_touch].frame; i < end; ++i) {
      if (in_opponent_box(soccer::Vec2(flow_.record->ball_position[i]) * sign)) {
        return ChainResult::kBoxEntry;
      }
    }
    return touched ? ChainResult::kLost : ChainResult::kOut;
  }

  const Flow& flow_;
  const std::vector<Pass>& passes_;
  const std::vector<Shot>& shots_;
  std::size_t pass_ = 0;
  std::size_t shot_ = 0;
};

}  // namespace

std::string_view name(ChainResult result) { return kResultNames.name(result); }

std::vector<Chain> find_chains(const Flow& flow, const std::vector<Pass>& passes,
                               const std::vector<Shot>& shots) {
  std::vector<Chain> chains;
  ChainClassifier judge(flow, passes, shots);
  for (std::size_t i = 0; i < flow.touches.size();) {
    const Touch& first = flow.touches[i];
    if (first.contested() || first.live_phase < 0) {
      ++i;
      continue;
    }

    Chain chain;
    chain.team = team_of(first.slot);
    chain.first_touch = static_cast<std::uint32_t>(i);
    while (i + 1 < flow.touches.size() && continues(flow.touches[i + 1], chain, flow.touches[i])) {
      ++i;
    }

    chain.last_touch = static_cast<std::uint32_t>(i++);
    judge.judge(chain);
    chains.push_back(chain);
  }
  return chains;
}

const Chain* chain_of(const std::vector<Chain>& chains, const Shot& shot) {
  const auto chain = std::ranges::find_if(chains, [&](const Chain& one) {
    return one.first_touch <= shot.touch && shot.touch <= one.last_touch;
  });
  return chain == chains.end() ? nullptr : &*chain;
}

Assist find_assist(const Flow& flow, const std::vector<Pass>& passes, const Shot& shot) {
  Assist assist;
  const Touch& taken = flow.touches[shot.touch];
  const gamelog::MatchRecord& record = *flow.record;
  std::int8_t receiver = shot.slot;

  // No opponent touched the ball between pass and shot.
  const auto in_chain = [&](const Pass& pass) {
    return std::all_of(flow.touches.begin() + pass.touch, flow.touches.begin() + shot.touch,
                       [&](const Touch& touch) {
                         return touch.live_phase == taken.live_phase && !touch.contested() &&
                                same_team(touch.slot, shot.slot);
                       });
  };

  auto at = std::ranges::lower_bound(passes, shot.touch, {}, &Pass::touch);
  while (at != passes.begin()) {
    --at;
    const std::uint32_t frame = flow.touches[at->touch].frame;
    const bool recent = record.time[taken.frame] - record.time[frame] <= kAssistCycles;
    if (!at->completed() || at->receiver != receiver || !in_chain(*at)) return assist;
    if (assist.passer != kNoPlayer) {
      assist.second = at->passer;
      return assist;
    }
    if (!recent) return assist;
    assist.passer = at->passer;
    receiver = at->passer;
  }
  return assist;
}

}  // namespace cls::analysis
