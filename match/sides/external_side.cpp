// Start, watch and shutdown of an external team.
#include "match/sides/external_side.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <thread>

#include "match/result/match_end.h"
#include "match/sides/side_sandbox.h"
#include "soccer/side.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr milliseconds kExitPollInterval{2};
constexpr milliseconds kKillScriptTimeout{1000};
constexpr milliseconds kKillScriptGrace{100};
// A connection is closed before the exit of its process is known.
constexpr milliseconds kAgentExitDelay{500};
// A team may hear of the end of the match, and leave, before the match does.
constexpr milliseconds kEndDelay{2000};
constexpr int kEndDelayCycles = 15;
// A coach is the last agent of a team to start.
constexpr int kCoachDelayCycles = 300;

milliseconds time_until(Clock::time_point end) {
  const auto left = std::chrono::duration_cast<milliseconds>(end - Clock::now());
  return std::max(left, milliseconds(0));
}

bool has_succeeded(const process::Child& child) {
  const auto exit = child.status().exit;
  return exit && !exit->by_signal && exit->number == 0;
}

}  // namespace

// A team in a sandbox cannot use the folder for temporary files of all programs.
Result<void> ExternalSide::make_temporary_folder() {
  if (temporary_) return {};
  TRY_INIT(auto folder, process::ScratchFolder::create());
  temporary_.emplace(std::move(folder));
  return {};
}

Result<void> ExternalSide::begin_use() {
  std::vector<std::filesystem::path> folders;
  for (const AgentPlan& agent : plan_.agents) folders.push_back(agent.command.folder);
  if (plan_.agents.front().command.empty_environment) {
    TRY(make_temporary_folder());
    folders.push_back(temporary_->path());
  }
  use_.begin(std::move(folders));
  return {};
}

Result<std::shared_ptr<process::Child>> ExternalSide::start(process::CommandPlan plan) {
  if (!plan.empty_environment) return host_.start(plan);
  TRY(make_temporary_folder());
  share_with_side(plan, temporary_->path(), namespaces_, limits_);
  return host_.start(plan);
}

Result<void> ExternalSide::start_next() {
  if (agents_.empty()) TRY(begin_use());
  const AgentPlan& next = plan_.agents[agents_.size()];
  TRY_INIT(auto child, start(next.command));
  agents_.push_back({next.unum, std::move(child)});
  return {};
}

bool ExternalSide::find_name(const ServerStatus& server, const std::vector<std::string>& others) {
  if (!name_.empty()) return true;
  for (const ReportedConnections& team : server.teams) {
    // Such a server takes players of the same name for one team, and refuses the twelfth.
    if (!server_.binds_clients()) {
      shared_name_hint_ = fmt::format("; or it plays under the name {} too", team.name);
    }
    if (std::ranges::find(others, team.name) != others.end()) continue;

    name_ = team.name;
    shared_name_hint_.clear();
    return true;
  }
  return false;
}

std::optional<MatchEnd> ExternalSide::join(const ServerStatus& server,
                                           const std::vector<std::string>& others) {
  const Result<void> step = continue_joining(server, others);
  if (step) return std::nullopt;
  MatchEnd end{.reason = EndReason::kRefused,
               .message = fmt::format("{}: {}", who(), step.error().message)};
  if (!agents_.empty()) end.failure = failure_of(*agents_.back().child);
  return end;
}

Result<void> ExternalSide::continue_joining(const ServerStatus& server,
                                            const std::vector<std::string>& others) {
  if (joined_) return {};
  if (agents_.empty()) return start_next();
  if (!find_name(server, others)) return {};
  const std::set<int>& players = server.team(name_)->players;
  on_pitch_ = static_cast<int>(players.size());

  if (plan_.contract == TeamPlan::Contract::kStartEachAgent) {
    // Players wait for each other; the coach, if any, is the last of the plan.
    const int started = std::min(static_cast<int>(agents_.size()), soccer::kPlayersPerTeam);
    if (on_pitch_ > started) {
      return Error{
          fmt::format("{} brought players {} onto the pitch: start is called once for each",
                      agents_.back().child->plan().name, fmt::join(players, ", "))};
    }
    if (on_pitch_ == started && agents_.size() < plan_.agents.size()) return start_next();
  }

  joined_ = on_pitch_ >= soccer::kPlayersPerTeam && agents_.size() == plan_.agents.size();
  return joined_ ? check_name() : Result<void>();
}

Result<void> ExternalSide::check_name() {
  if (name_ == identity().name || on_other_name_ == OnOtherName::kAccept) return {};
  std::string message =
      fmt::format("the team plays under the name {} instead of {}", name_, identity().name);
  if (on_other_name_ == OnOtherName::kRefuse) return Error{std::move(message)};
  if (plan_.takes_name) warnings_.push_back(std::move(message));
  return {};
}

std::string ExternalSide::waiting_for() const {
  if (plan_.contract == TeamPlan::Contract::kStartAll || agents_.empty()) {
    return fmt::format("{}: {} of 11 players of the {} team have joined", who(), on_pitch_,
                       side_name(identity().side));
  }
  return fmt::format("{}: {} has not joined", who(), agents_.back().child->plan().name);
}

// Only a server that knows whose process a client is gives the parts of a team one name.
std::string ExternalSide::timeout_hint() const {
  const bool one_name = plan_.mixed && !server_.binds_clients();
  return shared_name_hint_ + limit_hints() +
         (one_name ? "; on this server all parts of a mixed team must have one name" : "");
}

const process::Child* ExternalSide::awaited_process() const {
  return agents_.empty() ? nullptr : agents_.back().child.get();
}

const ExternalSide::Agent* ExternalSide::exited_agent() const {
  for (const Agent& agent : agents_) {
    if (process::has_ended(agent.child->status())) return &agent;
  }
  return nullptr;
}

const ExternalSide::Agent* ExternalSide::wait_for_exited_agent() const {
  const bool each = plan_.contract == TeamPlan::Contract::kStartEachAgent;
  const auto deadline = Clock::now() + kAgentExitDelay;
  while (each && exited_agent() == nullptr && Clock::now() < deadline) {
    std::this_thread::sleep_for(kExitPollInterval);
  }
  return exited_agent();
}

MatchEnd ExternalSide::exit_failure(const process::Child& child, const MatchMoment& moment) const {
  MatchEnd end;
  end.reason = moment.playing ? EndReason::kCrashed : EndReason::kRefused;
  end.fault_unknown = may_be_refused_for_its_name(child);
  end.failure = failure_of(child);
  end.message = fmt::format(
      "{}: the process of {} ended {}: {}{}{}", who(), child.plan().name,
      moment.playing ? fmt::format("at cycle {}", moment.cycle) : "before the match",
      end.failure->exit,
      limit_hint(child) + (moment.playing
                               ? std::string()
                               : sandbox_hint(child, "use --no-sandbox") + options_hint(child)),
      shared_name_hint_);
  return end;
}

// Processes may die below a script that still runs or has succeeded.
std::string ExternalSide::limit_hints() const {
  const auto limited = std::ranges::find_if(
      agents_, [](const Agent& agent) { return agent.child->status().at_cpu_limit; });
  return limited == agents_.end() ? std::string() : limit_hint(*limited->child);
}

// Its place may be taken: by a team of the same name, or by one that plays under its name.
bool ExternalSide::may_be_refused_for_its_name(const process::Child& child) const {
  if (shared_name_hint_.empty()) return false;
  constexpr std::string_view kNoPlace[] = {"no_more_"};
  return has_succeeded(child) || prints_any(child, kNoPlace);
}

// A start.sh that prints its help instead of starting anything.
std::string ExternalSide::options_hint(const process::Child& child) const {
  const bool starts_all = plan_.contract == TeamPlan::Contract::kStartAll;
  if (!starts_all || !has_succeeded(child) || on_pitch_ > 0) return {};

  const std::vector<std::string>& argv = child.plan().argv;
  return fmt::format(
      "; it was called with {}: a start.sh with other options needs a script that "
      "translates them (cls help matches)",
      fmt::join(argv.begin() + 1, argv.end(), " "));
}

// A server may continue without the players that a limit has ended.
std::vector<std::string> ExternalSide::take_warnings() {
  constexpr std::string_view kSeparator = "; ";
  const std::string hint = limit_hints();
  if (!hint.empty() && exited_agent() == nullptr && !warned_of_limit_) {
    warned_of_limit_ = true;
    warnings_.push_back(hint.substr(kSeparator.size()));
  }
  return std::exchange(warnings_, {});
}

// A server that reports connections shows a lost player before its process exits.
std::optional<MatchEnd> ExternalSide::lost_player_failure(const MatchMoment& moment) {
  const std::optional<int> unum = server_.lost_player(identity().side);
  if (!unum) return std::nullopt;
  const Agent* exited = wait_for_exited_agent();
  if (exited != nullptr && exited->unum == *unum) return exit_failure(*exited->child, moment);
  return MatchEnd{.reason = EndReason::kCrashed,
                  .message = fmt::format("{}: player {} has left (at cycle {}){}", who(), *unum,
                                         moment.cycle, limit_hints())};
}

void ExternalSide::warn_of_missing_coach(const MatchMoment& moment) {
  if (plan_.coach_port == 0 || moment.cycle < kCoachDelayCycles || looked_for_coach_) return;

  looked_for_coach_ = true;
  const ServerStatus status = server_.status();
  const ReportedConnections* team = status.team(name_);
  if (team == nullptr || team->coach) return;
  warnings_.push_back(fmt::format(
      "no coach has joined at port {}: the team plays without; --no-coach if it has none",
      plan_.coach_port));
}

std::optional<MatchEnd> ExternalSide::failure(const MatchMoment& moment) {
  if (moment.playing) warn_of_missing_coach(moment);
  if (moment.playing && server_.reports_lost_players()) return lost_player_failure(moment);

  const Agent* exited = exited_agent();
  if (exited == nullptr) return std::nullopt;
  if (!exit_) exit_ = AgentExit{exited->child.get(), moment.cycle, Clock::now()};
  const bool may_be_the_end = moment.playing && Clock::now() - exit_->at < kEndDelay;
  if (may_be_the_end && !exited_before_the_end(moment.cycle)) return std::nullopt;
  return exit_failure(*exit_->child, {moment.playing, exit_->cycle});
}

bool ExternalSide::exited_before_the_end(int cycle) const {
  return exit_ && cycle > exit_->cycle + kEndDelayCycles;
}

std::optional<MatchEnd> ExternalSide::final_failure(const MatchMoment& moment) {
  if (!exited_before_the_end(moment.cycle)) return std::nullopt;
  return exit_failure(*exit_->child, {moment.playing, exit_->cycle});
}

// The kill script may end agents of other teams, looking for its own by name.
void ExternalSide::leave() {
  if (agents_.empty()) return;
  for (const process::CommandPlan& kill : plan_.kills) {
    if (auto script = start(kill)) kill_scripts_.push_back(*std::move(script));
  }
  kill_script_deadline_ = Clock::now() + kKillScriptTimeout;
}

void ExternalSide::terminate() {
  for (const auto& script : kill_scripts_) {
    script->wait_exit(time_until(kill_script_deadline_));
    script->end(kKillScriptGrace);
  }
  for (const Agent& agent : agents_) agent.child->end(kTerminateGrace);
}

std::vector<ProcessResult> ExternalSide::wait_gone() {
  const auto deadline = Clock::now() + kTerminateGrace + kKillMargin;
  std::vector<ProcessResult> results;
  for (const Agent& agent : agents_) agent.child->wait_gone(time_until(deadline));
  for (const Agent& agent : agents_) results.push_back(result_of(*agent.child));
  for (const auto& script : kill_scripts_) {
    script->wait_gone(time_until(deadline));
    results.push_back(result_of(*script));
  }
  return results;
}

TeamResult ExternalSide::result() const {
  TeamResult result;
  result.name = team_name();
  result.endpoint = identity().endpoint;
  for (const Agent& agent : agents_) result.cpu_seconds += agent.child->cpu_seconds();
  return result;
}

}  // namespace cls::match
