// Start scripts of external teams as command plans.
#include "match/programs/team_folder.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/io/whole_file.h"
#include "match/programs/team_sandbox.h"

namespace cls::match {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;

constexpr int kPlayers = 11;
constexpr int kCoachUnum = 12;

std::vector<fs::path> hidden_folders(const TeamValues& values) {
  std::vector<fs::path> hidden = values.hidden;
  hidden.push_back(values.folder);
  return hidden;
}

process::CommandPlan plan_of(const fs::path& team, const TeamValues& values,
                             const fs::path& program, const std::string& who,
                             const std::string& log) {
  process::CommandPlan plan;
  plan.name = fmt::format("{} {}", side_name(values.side), who);
  plan.argv = {program.string()};
  plan.folder = team;
  plan.log = values.folder / fmt::format("{}-{}.log", side_name(values.side), log);
  plan.cpus = values.cpus;
  plan.limits = values.limits;
  if (values.sandbox) put_in_sandbox(plan, team, hidden_folders(values), values.namespaces);
  return plan;
}

process::CommandPlan agent_plan(const fs::path& team, const TeamValues& values, int number) {
  const std::string who = number == kCoachUnum ? "coach" : fmt::format("player {}", number);
  const std::string log = number == kCoachUnum ? "coach" : fmt::format("player-{:02}", number);
  process::CommandPlan plan = plan_of(team, values, team / "start", who, log);
  plan.argv.insert(plan.argv.end(),
                   {values.host, team.string(), std::to_string(number),
                    std::to_string(values.ports.player), std::to_string(values.ports.coach)});
  return plan;
}

process::CommandPlan whole_team_plan(const fs::path& team, const TeamValues& values) {
  process::CommandPlan plan = plan_of(team, values, team / "start.sh", "team", "team");
  plan.argv.insert(plan.argv.end(),
                   {"-h", values.host, "-p", std::to_string(values.ports.player), "-P",
                    std::to_string(values.ports.coach), "-t", values.team_name});
  if (!values.coach) plan.argv.push_back("-C");
  return plan;
}

}  // namespace

Result<TeamPlan> team_plan(const fs::path& folder, const TeamValues& values) {
  if (const auto why = base::why_no_folder(folder)) {
    return Error{fmt::format("team folder {}: {}", folder.string(), *why)};
  }
  std::error_code code;
  const fs::path team = fs::canonical(folder, code);
  const bool each = fs::exists(team / "start", code);
  const fs::path program = team / (each ? "start" : "start.sh");
  if (!fs::exists(program, code)) {
    return Error{fmt::format("team folder {}: neither start nor start.sh in it", folder.string())};
  }
  if (const auto found = process::find_program(program.string()); !found) {
    return Error{fmt::format("team folder {}: {}", folder.string(), found.error().message)};
  }

  TeamPlan plan;
  if (values.coach) plan.coach_port = values.ports.coach;
  if (each) {
    const int last = values.coach ? kCoachUnum : kPlayers;
    for (int number = 1; number <= last; ++number) {
      plan.agents.push_back({number, agent_plan(team, values, number)});
    }
  } else {
    plan.contract = TeamPlan::Contract::kStartAll;
    plan.takes_ports = plan.takes_name = true;
    plan.agents.push_back({0, whole_team_plan(team, values)});
  }
  if (process::find_program((team / "kill").string())) {
    plan.kills.push_back(plan_of(team, values, team / "kill", "kill script", "kill"));
  }
  return plan;
}

std::vector<fs::path> team_folders(const Endpoint& side) {
  if (side.kind != Endpoint::Kind::kTeam) return {};
  if (side.parts.empty()) return {side.path};
  std::vector<fs::path> folders;
  for (const Endpoint& part : side.parts) folders.emplace_back(part.path);
  return folders;
}

Result<TeamPlan> team_plan(const Endpoint& side, const TeamValues& values) {
  if (side.parts.empty()) return team_plan(fs::path(side.path), values);
  TeamPlan mixed;
  mixed.mixed = true;
  mixed.takes_name = true;  // the server names the side
  for (const Endpoint& part : side.parts) {
    TeamValues own = values;
    for (const Endpoint& other : side.parts) {
      if (other.path != part.path) own.hidden.emplace_back(other.path);
    }

    TRY_INIT(auto plan, team_plan(fs::path(part.path), own));
    if (plan.contract != TeamPlan::Contract::kStartEachAgent) {
      return Error{fmt::format(
          "team folder {}: a part of a mixed team needs start, which starts one player; start.sh "
          "starts all",
          part.path)};
    }

    for (AgentPlan& agent : plan.agents) {
      const bool is_own = std::ranges::find(part.agents, agent.unum) != part.agents.end();
      if (is_own) mixed.agents.push_back(std::move(agent));
    }
    for (process::CommandPlan& kill : plan.kills) mixed.kills.push_back(std::move(kill));
    mixed.coach_port = plan.coach_port;
  }

  std::ranges::sort(mixed.agents, {}, &AgentPlan::unum);
  return mixed;
}

}  // namespace cls::match
