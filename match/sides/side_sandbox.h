// What the programs of a side in a sandbox share.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/system/tcp_connect.h"
#include "match/sides/side_use.h"
#include "match/terms/match_options.h"
#include "process/namespaces.h"
#include "process/process_host.h"
#include "process/scratch_folder.h"

namespace cls::match {

/// Completes the plan of a program in a sandbox: `temporary` is its folder for temporary files,
/// `namespaces` those of its side, or null.
void share_with_side(process::CommandPlan& plan, const std::filesystem::path& temporary,
                     const std::shared_ptr<const process::Namespaces>& namespaces,
                     const SideLimits& limits);

/// A hint if a program in a sandbox prints that a file is missing, which the sandbox may withhold.
/// `without`: how the user turns the sandbox off.
std::string sandbox_hint(const process::Child& child, std::string_view without);

/// The sandbox of the Playmakers of one side, in a network of their own. Used by the match's thread
/// only, but for its sockets.
class PlaymakerSandbox {
 public:
  /// Null for a side without one. Logs of the match are in `folder`.
  static base::Result<std::shared_ptr<PlaymakerSandbox>> create(
      const MatchOptions& options, soccer::Side side, const std::filesystem::path& folder);

  /// Puts the Playmaker that `command` starts into it.
  void enclose(process::CommandPlan& plan, std::string_view command) const;
  /// Makes sockets that reach the Playmakers.
  const base::TcpSocketMaker& sockets() const { return sockets_; }
  /// See SideUse::excess().
  std::string excess(bool at_once) { return use_.excess(at_once); }

 private:
  PlaymakerSandbox(const MatchOptions& options, soccer::Side side,
                   std::shared_ptr<const process::Namespaces> namespaces,
                   process::ScratchFolder temporary);

  SideLimits limits_;
  std::shared_ptr<const process::Namespaces> namespaces_;
  process::ScratchFolder temporary_;
  std::vector<std::filesystem::path> hidden_;
  SideUse use_;
  base::TcpSocketMaker sockets_;
};

}  // namespace cls::match
