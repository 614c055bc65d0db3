// Measures turns, estimates the duration, judges the decisions.
#include "match/match_speed.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace cls::match {
namespace {

// A slow match reports after this how long it will take.
constexpr std::chrono::seconds kEstimateAfter{5};
constexpr double kLongMatch_s = 60.0;
constexpr std::int64_t kStepsOfEstimate = 3;

DecisionTimes decision_times(const Sides& sides) {
  constexpr double kMs = 1000.0;
  DecisionTimes slower;
  for (const auto& side : sides) {
    const proxy::LatencySamples* turns = side->turn_samples();
    if (turns == nullptr) continue;
    slower.p50 = std::max(slower.p50, turns->percentile(0.50) / kMs);
    slower.p99 = std::max(slower.p99, turns->percentile(0.99) / kMs);
    slower.max = std::max(slower.max, turns->max() / kMs);
  }
  return slower;
}

// More than one decision in a hundred.
bool is_often_late(const TeamResult& team) {
  const ReplySummary sum = reply_summary(team);
  return sum.late * 100 > sum.decisions;
}

}  // namespace

void MatchSpeed::add_step(Duration clock, Duration server) {
  meter_.add_clock(clock);
  meter_.add_server(server);
}

void MatchSpeed::add_turns(Duration wall) {
  std::array<SpeedMeter::SideTurn, 3> turns;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const TurnTimes now = sides_[i]->turn_times();
    TurnTimes turn{now.total - measured_[i].total, now.playmaker - measured_[i].playmaker};
    if (sides_[i]->is_external()) turn = {wall, wall};
    measured_[i] = now;
    turns[i] = {sides_[i]->identity().side, turn};
  }
  meter_.add_turns(wall, std::span(turns).first(sides_.size()));
}

// In real time, or slowed down by --speed.
bool MatchSpeed::is_paced() const {
  return options_.speed.has_value() || mode_of(options_) == MatchMode::kRealtime ||
         std::ranges::any_of(sides_, [](const auto& side) {
           const auto seen = side->seen();
           return seen && seen->mode == MatchMode::kRealtime;
         });
}

SpeedResult MatchSpeed::shares(Duration played) const {
  if (measure_ == Measure::kCycles) return meter_.result();

  SpeedMeter meter;
  std::array<SpeedMeter::SideTurn, 3> turns;
  Duration longest{0};
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    turns[i] = {sides_[i]->identity().side, sides_[i]->turn_times()};
    if (awaited_s_ && sides_[i]->is_external()) {
      const auto waited = std::chrono::duration_cast<Duration>(
          std::chrono::duration<double>((*awaited_s_)[turns[i].side]));
      turns[i].times = {waited, waited};
    }
    longest = std::max(longest, turns[i].times.total);
  }

  longest = std::min(longest, played);
  meter.add_turns(longest, std::span(turns).first(sides_.size()));
  is_paced() ? meter.add_clock(played - longest) : meter.add_server(played - longest);

  SpeedResult result = meter.result();
  const bool hidden = !awaited_s_ && std::ranges::any_of(sides_, is_external);
  if (hidden && result.limited_by == SpeedLimit::kServer) {
    result.limited_by = SpeedLimit::kServerAndTeams;
  }
  return result;
}

std::optional<std::string> MatchSpeed::estimate(const MatchProgress& now, std::int64_t steps,
                                                Duration played) {
  if (estimated_ || now.last_cycle <= 0 || now.cycle <= 0) return std::nullopt;
  if (!kick_off_) kick_off_ = Moment{played, steps};

  const Duration since = played - kick_off_->played;
  if (since < kEstimateAfter || steps - kick_off_->steps < kStepsOfEstimate) return std::nullopt;
  if (sides_.size() == 1 || is_paced()) return std::nullopt;
  estimated_ = true;

  // Steps with a stopped clock take as long as others; those in which teams join do not.
  const double played_s = std::chrono::duration<double>(played).count();
  const double rate =
      static_cast<double>(steps - kick_off_->steps) / std::chrono::duration<double>(since).count();
  const double left_s = (now.last_cycle - now.cycle) / rate;
  if (left_s < kLongMatch_s) return std::nullopt;
  return fmt::format("{:.{}f} cycles/s: {} cycles will take about {:.0f} min; {}", rate,
                     rate < 10 ? 1 : 0, now.last_cycle, (played_s + left_s) / 60.0,
                     limiting_party(shares(played)));
}

std::optional<SpeedResult> MatchSpeed::result(Duration played, const MatchResult& result) const {
  if (result.steps == 0) return std::nullopt;
  SpeedResult speed = shares(played);
  if (speed.limited_by == SpeedLimit::kNothing) return std::nullopt;
  speed.decision_ms = decision_times(sides_);
  speed.fits_100_ms = speed.decision_ms.p99 <= static_cast<double>(kRealtimeDeadline.count()) &&
                      !is_often_late(result.left) && !is_often_late(result.right);
  return speed;
}

}  // namespace cls::match
