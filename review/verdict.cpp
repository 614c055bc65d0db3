// Halves of playouts: one to choose, one to estimate.
#include "review/verdict.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/confidence.h"

namespace cls::review {

Estimate mean_difference(const Worths& a, const Worths& b, std::size_t begin, std::size_t end) {
  const auto count = static_cast<double>(end - begin);
  double sum = 0.0;
  for (std::size_t i = begin; i < end; ++i) sum += a[i] - b[i];
  const double mean = sum / count;

  double squares = 0.0;
  for (std::size_t i = begin; i < end; ++i) squares += std::pow(a[i] - b[i] - mean, 2);
  const double error = count < 2.0 ? 0.0 : std::sqrt(squares / (count - 1.0) / count);
  return {mean, mean - base::kNormal95 * error, mean + base::kNormal95 * error};
}

Verdict judge(PlayedDecision played, std::size_t match) {
  Verdict verdict;
  verdict.match = match;
  const std::size_t all = played.recorded.size();
  const std::size_t half = all / 2;

  double most = 0.0;
  for (std::size_t i = 0; i < played.worths.size(); ++i) {
    const Estimate gain = mean_difference(played.worths[i], played.recorded, 0, half);
    if (gain.value <= most) continue;
    most = gain.value;
    verdict.better = i;
  }

  if (verdict.better) {
    verdict.cost = mean_difference(played.worths[*verdict.better], played.recorded, half, all);
  }
  verdict.played = std::move(played);
  return verdict;
}

std::vector<VerdictGroup> group(const std::vector<Verdict>& verdicts) {
  std::map<std::pair<std::string, std::string>, std::pair<VerdictGroup, double>> groups;
  for (const Verdict& verdict : verdicts) {
    if (!verdict.better) continue;
    const std::string recorded(kDecisionNames.name(verdict.played.decision.kind));
    auto& [sum, variance] = groups[{recorded, verdict.best()->group}];
    sum.recorded = recorded;
    sum.better = verdict.best()->group;
    ++sum.decisions;
    sum.cost.value += verdict.cost.value;
    variance += std::pow((verdict.cost.high - verdict.cost.low) / 2.0, 2);
  }

  std::vector<VerdictGroup> sorted;
  for (auto& [key, entry] : groups) {
    auto& [sum, variance] = entry;
    sum.cost.low = sum.cost.value - std::sqrt(variance);
    sum.cost.high = sum.cost.value + std::sqrt(variance);
    sorted.push_back(sum);
  }
  std::ranges::stable_sort(sorted, std::ranges::greater{},
                           [](const VerdictGroup& one) { return one.cost.value; });
  return sorted;
}

}  // namespace cls::review
