// Joining step by step, ending in order.
#include "orchestration/match/sides/foreign_team.h"

#include <fmt/format.h>

#include <algorithm>

#include "orchestration/match/sides/playmaker_program.h"
#include "soccer/side.h"

namespace cls::orchestration::match {
namespace {

using base::Error;
using base::Result;
using std::chrono::milliseconds;

constexpr milliseconds kKillScriptLimit{1000};
constexpr milliseconds kKillScriptGrace{100};

milliseconds time_until(std::chrono::steady_clock::time_point end) {
  const auto left = end - std::chrono::steady_clock::now();
  return std::max(std::chrono::duration_cast<milliseconds>(left), milliseconds(0));
}

}  // namespace

Result<void> ForeignTeam::start_next() {
  auto child = host_.start(plan_.agents[agents_.size()]);
  if (!child) return child.error();
  agents_.push_back(std::move(*child));
  return {};
}

bool ForeignTeam::find_name(const ServerNews& news, const std::vector<std::string>& others) {
  if (!name_.empty()) return true;
  for (const AnnouncedTeam& team : news.teams) {
    if (std::find(others.begin(), others.end(), team.name) != others.end()) continue;
    name_ = team.name;
    return true;
  }
  return false;
}

Result<void> ForeignTeam::join(const ServerNews& news, const std::vector<std::string>& others) {
  if (joined_) return {};
  if (agents_.empty()) return start_next();
  if (!find_name(news, others)) return {};
  on_pitch_ = static_cast<int>(news.team(name_)->players.size());
  if (plan_.contract == TeamPlan::Contract::kStartEachAgent) {
    // Players wait for each other; the coach, if any, is the last of the plan.
    const int started = std::min(static_cast<int>(agents_.size()), soccer::kPlayersPerTeam);
    if (on_pitch_ > started) {
      return Error{
          fmt::format("{} brought players {} onto the pitch: start is called once for each",
                      agents_.back()->plan().name, fmt::join(news.team(name_)->players, ", "))};
    }
    if (on_pitch_ == started && agents_.size() < plan_.agents.size()) return start_next();
  }
  joined_ = on_pitch_ >= soccer::kPlayersPerTeam && agents_.size() == plan_.agents.size();
  return {};
}

std::string ForeignTeam::waiting_for() const {
  const std::string& first = plan_.agents.front().name;
  const std::string side = first.substr(0, first.find(' '));
  if (plan_.contract == TeamPlan::Contract::kStartAll || agents_.empty()) {
    return fmt::format("{} of 11 players of the {} team have joined", on_pitch_, side);
  }
  return fmt::format("{} has not joined", agents_.back()->plan().name);
}

const process::Child* ForeignTeam::dead_agent() const {
  for (const auto& agent : agents_) {
    if (process::has_ended(agent->status())) return agent.get();
  }
  return nullptr;
}

void ForeignTeam::call_kill_script() {
  if (!plan_.kill || agents_.empty()) return;
  auto script = host_.start(*plan_.kill);
  if (!script) return;
  kill_script_ = std::move(*script);
  kill_script_until_ = std::chrono::steady_clock::now() + kKillScriptLimit;
}

void ForeignTeam::end(std::chrono::milliseconds grace) {
  if (kill_script_ != nullptr) {
    kill_script_->wait_exit(time_until(kill_script_until_));
    kill_script_->end(kKillScriptGrace);
  }
  for (const auto& agent : agents_) agent->end(grace);
}

void ForeignTeam::wait_gone(std::chrono::milliseconds limit) const {
  const auto until = std::chrono::steady_clock::now() + limit;
  for (const auto& agent : agents_) agent->wait_gone(time_until(until));
  if (kill_script_ != nullptr) kill_script_->wait_gone(time_until(until));
}

double ForeignTeam::cpu_seconds() const {
  double seconds = 0.0;
  for (const auto& agent : agents_) seconds += agent->cpu_seconds();
  return seconds;
}

std::vector<ProcessResult> ForeignTeam::results() const {
  std::vector<ProcessResult> results;
  for (const auto& agent : agents_) results.push_back(result_of(*agent));
  if (kill_script_ != nullptr) results.push_back(result_of(*kill_script_));
  return results;
}

}  // namespace cls::orchestration::match
