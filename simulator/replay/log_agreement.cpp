// Statistics of a log replay.
#include "simulator/replay/log_agreement.h"

#include <algorithm>
#include <cmath>

namespace cls::simulator {
namespace {

constexpr std::array<std::string_view, kExcuseCount> kExcuses = {
    "tackle", "catch", "foul",    "random_place", "half_time",
    "noise",  "line",  "toucher", "came_or_left"};

}  // namespace

std::string_view name(Excuse excuse) { return kExcuses[static_cast<std::size_t>(excuse)]; }

double NoiseSample::mean() const {
  double sum = 0.0;
  for (const double share : shares) sum += share;
  return shares.empty() ? 0.0 : sum / static_cast<double>(shares.size());
}

double NoiseSample::largest() const {
  return shares.empty() ? 0.0 : *std::max_element(shares.begin(), shares.end());
}

double NoiseSample::distance_to_uniform() const {
  std::vector<double> sorted = shares;
  std::sort(sorted.begin(), sorted.end());
  const double n = static_cast<double>(sorted.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double x = std::min(sorted[i], 1.0);
    distance = std::max({distance, std::fabs(x - static_cast<double>(i) / n),
                         std::fabs(x - static_cast<double>(i + 1) / n)});
  }
  return distance;
}

double LogAgreement::excused_share() const {
  const int all = steps() + uncounted;
  return all == 0 ? 0.0 : static_cast<double>(excused) / all;
}

}  // namespace cls::simulator
