// Prints the plan of a match.
#include "match/dry_run.h"

#include <fmt/format.h>

#include <iterator>

#include "match/programs/team_sandbox.h"
#include "match/run_match.h"
#include "match/server/match_plan.h"
#include "match/terms/run_command.h"
#include "soccer/side.h"

namespace cls::match {
namespace {

namespace fs = std::filesystem;
using base::Result;

void add(std::string& text, const process::CommandPlan& plan) {
  const char* sandboxed = plan.files ? " (in a sandbox: docs/security.md)" : "";
  fmt::format_to(std::back_inserter(text), "# {}{}\n{}\n", plan.name, sandboxed,
                 process::to_shell(plan));
}

// The command of a Playmaker, or a comment on one that runs already.
Result<void> add_playmaker(std::string& text, const MatchOptions& options, const TeamNames& names,
                           soccer::Side side, const Endpoint& endpoint, const fs::path& folder) {
  for (const Endpoint& part : endpoint.parts) {
    TRY(add_playmaker(text, options, names, side, part, folder));
  }
  if (endpoint.kind == Endpoint::Kind::kMixed) return {};
  if (endpoint.kind != Endpoint::Kind::kRun) {
    fmt::format_to(std::back_inserter(text), "# {}: {}\n", playmaker_name(side, endpoint.label),
                   endpoint.text);
    return {};
  }

  TRY_INIT(const auto port, process::ReservedPort::choose(1));
  const bool trainer = side == soccer::Side::kNeutral;
  const RunValues values = {port.front().number(), side, trainer ? names.left : names[side],
                            options.seed.value_or(0), endpoint.label};
  process::CommandPlan plan = run_plan(endpoint.command, values, folder);
  plan.limits = options.limits;
  if (!trainer) plan.cpus = options.cpus[side];
  if (has_sandboxed_playmakers(options, side)) {
    put_playmaker_in_sandbox(plan, endpoint.command, hidden_from_playmakers(options, side, folder));
  }
  add(text, plan);
  return {};
}

}  // namespace

Result<std::string> dry_run(const MatchOptions& options) {
  const TeamNames names = team_names(options);
  const fs::path folder =
      fs::absolute(options.folder.empty()
                       ? fs::path("runs") / fmt::format("UTC-{}-vs-{}", names.left, names.right)
                       : options.folder);

  MatchPlan plan;
  std::string text = "# soccer server: embedded, in this process\n";
  if (mode_of(options) != MatchMode::kLockstep) {
    TRY_INIT(auto planned, plan_match(options, names, options.seed.value_or(0), folder));
    plan = std::move(planned);
    text = fmt::format("# soccer server: {}\n", options.server_choice.text);
    if (plan.server) add(text, *plan.server);
  }

  for (const auto side : soccer::kBothSides) {
    const auto& team = plan.teams[side];
    if (!team) {
      TRY(add_playmaker(text, options, names, side, endpoint_of(options, side), folder));
      continue;
    }
    for (const AgentPlan& agent : team->agents) add(text, agent.command);
    for (const process::CommandPlan& kill : team->kills) add(text, kill);
  }

  if (options.trainer) {
    TRY(add_playmaker(text, options, names, soccer::Side::kNeutral, *options.trainer, folder));
  }
  return text;
}

}  // namespace cls::match
