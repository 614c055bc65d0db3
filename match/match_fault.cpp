// Attribution of stalls and failures to a side.
#include "match/match_fault.h"

#include <fmt/format.h>

#include <algorithm>

#include "match/terms/server_settings.h"
#include "soccer/side.h"

namespace cls::match {

std::vector<const MatchSide*> sides_awaited_for(const Sides& sides,
                                                std::chrono::duration<double> limit) {
  std::vector<const MatchSide*> found;
  for (const auto& side : sides) {
    const auto call = side->awaited_reply();
    if (call && call->waited > limit) found.push_back(side.get());
  }
  return found;
}

void blame(const MatchSide& side, const MatchMoment& moment, MatchEnd& end) {
  if (!is_trainer(side)) end.fault = side.identity().side;
  if (side.is_external() && moment.playing) return;  // any of its programs may be the one
  if (const process::Child* child = side.awaited_process()) {
    end.failure = failure_of(*child);
  } else if (!side.is_external()) {
    end.failure = playmaker_failure(side.identity().side);
  }

  const auto call = side.awaited_reply();
  if (!call || !end.failure) return;
  end.failure->rpc = name(call->rpc);
  end.failure->unum = call->agent;
  if (moment.playing) end.failure->cycle = moment.cycle;
}

void blame_unresponsive(const Sides& sides, const std::optional<soccer::PerSide<double>>& awaited_s,
                        MatchEnd& end) {
  constexpr double kComparable = 0.5;
  const auto has_waited = [&awaited_s](soccer::Side side) {
    if (!awaited_s) return true;
    return (*awaited_s)[side] > kComparable * std::max(awaited_s->left, awaited_s->right);
  };

  auto suspects = sides_awaited_for(sides, kServerWait);
  for (const auto& side : sides) {
    if (side->is_external() && has_waited(side->identity().side)) suspects.push_back(side.get());
  }
  if (suspects.size() != 1) return;

  end.message += ": those of " + suspects.front()->who();
  if (!is_trainer(*suspects.front())) end.fault = suspects.front()->identity().side;
}

double share_of(const SpeedResult& speed, soccer::Side side) {
  return side == soccer::Side::kLeft ? speed.shares.left_playmaker : speed.shares.right_playmaker;
}

std::optional<soccer::Side> side_of_most_time(const std::optional<SpeedResult>& speed) {
  constexpr double kHalf = 0.5;
  for (const soccer::Side side : soccer::kBothSides) {
    if (speed && share_of(*speed, side) > kHalf) return side;
  }
  return std::nullopt;
}

ProcessorTime processor_time(const std::vector<ProcessResult>& processes, soccer::Side side) {
  const std::string prefix = fmt::format("{} ", side_name(side));
  ProcessorTime sum;
  for (const ProcessResult& process : processes) {
    if (!process.name.starts_with(prefix)) continue;
    sum.used_s += process.cpu_seconds;
    sum.delayed_s += process.delayed_seconds;
  }
  return sum;
}

bool was_starved(const ProcessorTime& own, const ProcessorTime& opponent) {
  constexpr double kMuchMore = 2.0;
  return own.delayed_s > own.used_s && opponent.used_s > kMuchMore * own.used_s;
}

std::string stall_message(const std::vector<const MatchSide*>& sides, int cycle,
                          const std::string& stall) {
  std::string message;
  for (const MatchSide* side : sides) {
    if (!message.empty()) message += "; ";
    message += side->who();
    if (const auto call = side->awaited_reply()) {
      message += fmt::format(": no reply to {} at cycle {}", describe(*call), cycle);
    }
  }
  return fmt::format("{}: {}", message, stall);
}

}  // namespace cls::match
