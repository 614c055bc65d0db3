// Counts time from the date of the log.
#include "analysis/tables/cdf_match.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "base/text/enum_names.h"
#include "base/text/number_text.h"

namespace cls::analysis {
namespace {

using std::chrono::milliseconds;
using std::chrono::sys_days;

// No period has the number 0.
constexpr auto kPeriodNames = base::enum_names<PeriodKind>(
    "", "first_half", "second_half", "first_half_extratime", "second_half_extratime", "shootout");

// The two digits of a number; -1 for other text.
int two_digits(std::string_view text, std::size_t at) {
  return base::parse_int(text.substr(std::min(at, text.size()), 2)).value_or(-1);
}

// Milliseconds since 1970 of YYYYMMDDhhmm; 0 for other text.
long long milliseconds_of(std::string_view date) {
  const auto year = base::parse_int(date.substr(0, std::min<std::size_t>(4, date.size())));
  if (date.size() != 12 || !year) return 0;
  const std::chrono::year_month_day day{
      std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(two_digits(date, 4))),
      std::chrono::day(static_cast<unsigned>(two_digits(date, 6)))};
  const int hour = two_digits(date, 8);
  const int minute = two_digits(date, 10);
  if (!day.ok() || hour < 0 || hour > 23 || minute < 0 || minute > 59) return 0;
  const auto time =
      sys_days(day).time_since_epoch() + std::chrono::hours(hour) + std::chrono::minutes(minute);
  return std::chrono::duration_cast<milliseconds>(time).count();
}

std::string utc_text(long long since_1970) {
  const std::chrono::sys_time<milliseconds> time{milliseconds(since_1970)};
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss clock(time - day);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count(),
                     clock.subseconds().count());
}

}  // namespace

CdfMatch::CdfMatch(const gamelog::MatchRecord& of, std::string name)
    : record(of),
      id(std::move(name)),
      summary(summarize(of, nullptr)),
      statistics(compute_statistics(of, nullptr)),
      periods(find_periods(of)),
      teams(team_ids(summary)),
      start_(milliseconds_of(summary.date)) {}

std::string CdfMatch::time_of(std::size_t frame) const {
  const double passed = static_cast<double>(frame) * cycle_seconds(record.server) * 1000.0;
  return utc_text(start_ + std::llround(passed));
}

std::string CdfMatch::player_id(std::size_t slot) const {
  return fmt::format("{}_{}", teams[team_of(slot)], unum_of(slot));
}

std::string_view cdf_name(PeriodKind period) { return kPeriodNames.name(period); }

}  // namespace cls::analysis
