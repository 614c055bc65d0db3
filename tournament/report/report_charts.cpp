// Data of the charts.
#include "tournament/report/report_charts.h"

#include <fmt/format.h>

#include "tournament/report/report_tables.h"
#include "viewer/charts/charts.h"

namespace cls::tournament {
namespace {

std::vector<int> goal_differences(const Report& report, const HeadToHead& pair) {
  std::vector<int> differences;
  for (const ScheduledMatch& match : report.matches) {
    if (!match.outcome || !match.outcome->played()) continue;
    const int difference = match.outcome->left_score - match.outcome->right_score;
    const Fixture& fixture = match.fixture;
    if (fixture.left == pair.first && fixture.right == pair.second) {
      differences.push_back(difference);
    } else if (fixture.left == pair.second && fixture.right == pair.first) {
      differences.push_back(-difference);
    }
  }
  return differences;
}

}  // namespace

std::string ratings_chart(const Report& report) {
  viewer::RatingsData data;
  data.title = {"Ratings in Elo", "95 % intervals"};
  for (const std::size_t team : rated_teams(report)) {
    data.teams.push_back({report.team(static_cast<int>(team)), report.ratings.elo[team],
                          report.ratings.error[team]});
  }
  return viewer::ratings_chart(data);
}

std::vector<std::string> differences_charts(const Report& report) {
  constexpr std::size_t kMaxPairs = 6;
  constexpr std::size_t kMinMatches = 5;
  std::vector<std::string> charts;
  for (const HeadToHead& pair : report.head_to_heads) {
    viewer::DifferencesData data;
    data.title.text = fmt::format("Goals of {} minus those of {}", report.team(pair.first),
                                  report.team(pair.second));
    data.differences = goal_differences(report, pair);
    if (data.differences.size() < kMinMatches) continue;
    if (charts.size() == kMaxPairs) return {};
    charts.push_back(viewer::differences_chart(data));
  }
  return charts;
}

}  // namespace cls::tournament
