// Figures of matches, and Welch's test of each.
#include "review/reference.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "analysis/statistics/field_table.h"

namespace cls::review {
namespace {

using analysis::TeamStatistic;

// In double: with long double, which is the default, the library computes tables when any program
// starts that has this file, and ends it under Valgrind.
namespace policies = boost::math::policies;
using StudentsT =
    boost::math::students_t_distribution<double, policies::policy<policies::promote_double<false>>>;

constexpr double kCyclesOfAMatch = 6000.0;
constexpr double kConfidence = 0.95;

enum class Kind : unsigned char { kCount, kMean, kShare };

// A statistic that tells how a team plays; results of matches and shapes of the field are not.
struct Compared {
  const char* name;
  TeamStatistic statistic;
  Kind kind = Kind::kCount;
  const char* unit = "";
  bool of_the_opponent = false;
};

constexpr Compared kCompared[] = {
    {"expected goals", {"/shots/expected_goals"}, Kind::kCount, "goals"},
    {"expected goals against", {"/shots/expected_goals"}, Kind::kCount, "goals", true},
    {"goals", {"/shots/goal"}, Kind::kCount, "goals"},
    {"goals against", {"/shots/goal"}, Kind::kCount, "goals", true},
    {"shots", {"/shots/total"}},
    {"shots against", {"/shots/total"}, Kind::kCount, "", true},
    {"ball won or kept", {"/possession/last_touch"}, Kind::kShare, "%"},
    {"passes", {"/passes/attempted"}},
    {"passes completed", {"/passes/completion"}, Kind::kShare, "%"},
    {"mean length of passes", {"/passes/mean_length"}, Kind::kMean, "m"},
    {"through passes", {"/passes/through"}},
    {"crosses", {"/passes/crosses"}},
    {"opponents overtaken by passes", {"/passes/overtaken"}},
    {"dribbles", {"/dribbles"}},
    {"attacks that end in a loss", {"/chains/results/lost"}},
    {"entries into their penalty area", {"/territory/box_entries"}},
    {"entries into the own penalty area", {"/territory/box_entries"}, Kind::kCount, "", true},
    {"pitch control", {"/territory/pitch_control"}, Kind::kShare, "%"},
    {"tackles tried", {"/tackles/tried"}},
    {"interceptions", {"/interceptions"}},
    {"balls won back", {"/pressing/recoveries"}},
    {"their passes per defensive action", {"/pressing/passes_per_action"}, Kind::kMean},
    {"offsides", {"/stoppages/offsides"}},
    {"fouls", {"/stoppages/fouls"}},
    {"place of the back line", {"/shape/defence_x"}, Kind::kMean, "m"},
    {"cycles of exhausted players", {"/exhausted_frames"}},
};

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

double figure(const Compared& compared, const analysis::TeamView& view, double matches) {
  const std::optional<base::Json> value = compared.statistic.row->value(view);
  if (!value || !value->is_number()) return kMissing;
  const auto number = value->get<double>();
  switch (compared.kind) {
    case Kind::kCount:
      return matches > 0.0 ? number / matches : kMissing;
    case Kind::kShare:
      return 100.0 * number;
    case Kind::kMean:
      return number;
  }
  return kMissing;
}

struct Sample {
  double count = 0.0;
  double mean = 0.0;
  double error2 = 0.0;  // squared standard error of the mean
};

Sample sample_of(const std::vector<Figures>& matches, std::size_t index) {
  std::vector<double> values;
  for (const Figures& match : matches) {
    if (!std::isnan(match[index])) values.push_back(match[index]);
  }
  Sample sample;
  sample.count = static_cast<double>(values.size());
  if (values.size() < 2) return sample;

  for (const double value : values) sample.mean += value / sample.count;
  double squares = 0.0;
  for (const double value : values) squares += std::pow(value - sample.mean, 2);
  sample.error2 = squares / (sample.count - 1.0) / sample.count;
  return sample;
}

// Welch and Satterthwaite.
double degrees_of_freedom(const Sample& a, const Sample& b) {
  return std::pow(a.error2 + b.error2, 2) /
         (a.error2 * a.error2 / (a.count - 1.0) + b.error2 * b.error2 / (b.count - 1.0));
}

Difference compare(const Compared& compared, const Sample& team, const Sample& reference) {
  const double error = std::sqrt(team.error2 + reference.error2);
  const double outside = (1.0 - kConfidence) / static_cast<double>(std::size(kCompared));
  const StudentsT t(degrees_of_freedom(team, reference));
  const double half = error * boost::math::quantile(boost::math::complement(t, outside / 2.0));

  Difference difference;
  difference.statistic = compared.name;
  difference.unit = compared.unit;
  difference.team = team.mean;
  difference.reference = reference.mean;
  const double value = team.mean - reference.mean;
  difference.difference = {value, value - half, value + half};
  difference.errors = value / error;
  return difference;
}

}  // namespace

Figures figures_of(const analysis::MatchSummary& summary,
                   const analysis::MatchStatistics& statistics, soccer::Side side) {
  const std::size_t own = soccer::side_index(side);
  const analysis::TeamView views[] = {{summary, statistics, own}, {summary, statistics, 1 - own}};
  const double matches = summary.cycles / kCyclesOfAMatch;

  Figures figures;
  for (const Compared& compared : kCompared) {
    figures.push_back(figure(compared, views[compared.of_the_opponent ? 1 : 0], matches));
  }
  return figures;
}

std::vector<Difference> differences(const std::vector<Figures>& team,
                                    const std::vector<Figures>& reference) {
  std::vector<Difference> found;
  for (std::size_t i = 0; i < std::size(kCompared); ++i) {
    const Sample own = sample_of(team, i);
    const Sample other = sample_of(reference, i);
    const bool enough = own.count >= 2.0 && other.count >= 2.0;
    if (!enough || own.error2 + other.error2 <= 0.0) continue;
    found.push_back(compare(kCompared[i], own, other));
  }
  std::ranges::stable_sort(found, std::ranges::greater{},
                           [](const Difference& one) { return std::abs(one.errors); });
  return found;
}

}  // namespace cls::review
