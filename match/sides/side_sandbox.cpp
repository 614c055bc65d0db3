// Namespaces, a folder for temporary files, and sockets into a side's network.
#include "match/sides/side_sandbox.h"

#include <fmt/format.h>

#include <mutex>
#include <system_error>
#include <utility>

#include "match/programs/team_sandbox.h"
#include "match/result/match_end.h"
#include "soccer/side.h"

namespace cls::match {
namespace {

namespace fs = std::filesystem;

// Above that of the match, which says who exceeds it.
int kernel_limit(int processes) { return processes + processes / 4 + 64; }

// One request at a time.
base::TcpSocketMaker sockets_in(std::shared_ptr<const process::Namespaces> namespaces) {
  return [namespaces = std::move(namespaces), mutex = std::make_shared<std::mutex>()](int family) {
    const std::scoped_lock lock(*mutex);
    auto made = namespaces->door().make_tcp(family);
    return made ? *std::move(made) : base::UniqueFd();
  };
}

}  // namespace

void share_with_side(process::CommandPlan& plan, const fs::path& temporary,
                     const std::shared_ptr<const process::Namespaces>& namespaces,
                     const SideLimits& limits) {
  // In namespaces there are no links to it.
  std::error_code code;
  const fs::path folder = fs::canonical(temporary, code);
  if (plan.files) plan.files->writable.push_back(folder);
  plan.environment.push_back({"TMPDIR", folder.string()});
  plan.namespaces = namespaces;
  if (namespaces != nullptr) plan.limits.processes = kernel_limit(limits.processes);
}

std::string sandbox_hint(const process::Child& child, std::string_view without) {
  constexpr std::string_view kMissing[] = {"ermission denied", "cannot open shared object",
                                           "not found", "No module named", "No such file"};
  if (!child.plan().empty_environment || !prints_any(child, kMissing)) return {};
  return fmt::format(
      "; it runs in a sandbox: if it needs files outside of {} or variables of your environment, "
      "copy them there or {}",
      child.plan().folder.string(), without);
}

PlaymakerSandbox::PlaymakerSandbox(const MatchOptions& options, soccer::Side side,
                                   std::shared_ptr<const process::Namespaces> namespaces,
                                   process::ScratchFolder temporary)
    : limits_(options.side_limits),
      namespaces_(std::move(namespaces)),
      temporary_(std::move(temporary)),
      use_(side, options.side_limits),
      sockets_(sockets_in(namespaces_)) {}

base::Result<std::shared_ptr<PlaymakerSandbox>> PlaymakerSandbox::create(
    const MatchOptions& options, soccer::Side side, const fs::path& folder) {
  std::shared_ptr<PlaymakerSandbox> sandbox;
  if (!has_sandboxed_playmakers(options, side)) return sandbox;

  auto namespaces = process::Namespaces::create();
  if (!namespaces) {
    return base::Error{
        fmt::format("namespaces for the {} side: {}", side_name(side), namespaces.error().message)};
  }
  TRY_INIT(auto temporary, process::ScratchFolder::create());
  sandbox.reset(new PlaymakerSandbox(options, side, *std::move(namespaces), std::move(temporary)));
  sandbox->hidden_ = hidden_from_playmakers(options, side, folder);

  std::vector<fs::path> folders = {sandbox->temporary_.path()};
  for (const std::string& command : playmaker_commands(endpoint_of(options, side))) {
    folders.push_back(playmaker_folder(command));
  }
  sandbox->use_.begin(std::move(folders));
  return sandbox;
}

void PlaymakerSandbox::enclose(process::CommandPlan& plan, std::string_view command) const {
  put_playmaker_in_sandbox(plan, command, hidden_);
  share_with_side(plan, temporary_.path(), namespaces_, limits_);
}

}  // namespace cls::match
