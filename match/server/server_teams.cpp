// Start commands of teams.
#include "match/server/server_teams.h"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>

namespace cls::match {
namespace {

// rcssserver waits one second for each team after SIGINT.
constexpr std::chrono::milliseconds kInterruptGrace{1000};
constexpr std::chrono::milliseconds kEndGrace{1000};

void print(std::string_view line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

// A start command, as one line for the shell.
process::CommandPlan plan_of(const char* name, std::string command, const ServerPorts& ports) {
  std::ranges::replace(command, '\n', ' ');
  process::CommandPlan plan = process::shell_command(name, command);
  plan.environment = {{"CLS_SERVER_PORT", std::to_string(ports.player)},
                      {"CLS_SERVER_COACH_PORT", std::to_string(ports.trainer)},
                      {"CLS_SERVER_OLCOACH_PORT", std::to_string(ports.coach)}};
  return plan;
}

// Only to the command, like rcssserver: it stops its own players.
void interrupt(const process::Child& team) {
  const process::Child::Status status = team.status();
  if (status.exit) return;
  print(fmt::format("Killing {}", status.pid));
  ::kill(status.pid, SIGINT);
}

}  // namespace

base::Result<ServerTeams> ServerTeams::create(const soccer::ServerParams& params,
                                              const ServerPorts& ports) {
  ServerTeams made;
  if (params.team_l_start.empty() && params.team_r_start.empty()) return made;

  TRY_INIT(auto host, process::ProcessHost::create());
  made.host_.emplace(std::move(host));
  const auto prepare = [&ports](Team& team, const char* name, const std::string& command) {
    team.tried = command.empty();
    if (!command.empty()) team.plan = plan_of(name, command, ports);
  };
  prepare(made.teams_.left, "team_l_start", params.team_l_start);
  prepare(made.teams_.right, "team_r_start", params.team_r_start);
  return made;
}

void ServerTeams::poll(bool play_is_on, bool left_has_connected) {
  if (!host_) return;
  if (host_->changes() != seen_changes_) report_failures();
  if (play_is_on) return;
  start(teams_.left);
  if (left_has_connected) start(teams_.right);
}

void ServerTeams::start(Team& team) {
  if (std::exchange(team.tried, true)) return;
  print(fmt::format("Starting \"/bin/sh -c {}\"", team.plan.argv.back()));
  auto child = host_->start(team.plan, print);
  if (child) {
    team.child = *std::move(child);
  } else {
    fmt::print(stderr, "cls: {}\n", child.error().message);
  }
}

void ServerTeams::report_failures() {
  seen_changes_ = host_->changes();
  for (Team* team : {&teams_.left, &teams_.right}) report_failure(*team);
}

void ServerTeams::report_failure(Team& team) {
  if (team.child == nullptr || team.reported) return;

  const process::Child::Status status = team.child->status();
  if (!status.exit || (!status.exit->by_signal && status.exit->number == 0)) return;
  team.reported = true;
  fmt::print(stderr, "cls: {}: '{}' failed: {}\n", team.plan.name, team.plan.argv.back(),
             to_text(*status.exit));
}

void ServerTeams::terminate() {
  if (!host_) return;
  report_failures();
  for (const Team* team : {&teams_.left, &teams_.right}) {
    if (team->child != nullptr) interrupt(*team->child);
  }
  for (const Team* team : {&teams_.left, &teams_.right}) {
    if (team->child != nullptr) team->child->wait_exit(kInterruptGrace);
  }
  if (!host_->end_all(kEndGrace)) fmt::print(stderr, "cls: a team does not exit\n");
}

}  // namespace cls::match
