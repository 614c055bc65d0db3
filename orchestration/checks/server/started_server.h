// A soccer server that is started to be looked at: on free ports, in a folder of its own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/match/options/server_choice.h"
#include "orchestration/match/options/server_command.h"
#include "orchestration/match/server/server_output.h"
#include "orchestration/process/ports.h"
#include "orchestration/process/process_host.h"

namespace cls::orchestration::checks {

class ScratchFolder;

/// Ended, and its folder removed, with the object.
class StartedServer {
 public:
  /// `choice` is no address; embedded: `own_program server`. Synchronous mode, with these
  /// parameters. The error says why it cannot be started; that it stays alive is not waited for.
  static base::Result<StartedServer> start(const match::ServerChoice& choice,
                                           const std::string& own_program,
                                           const soccer::ServerParams& params);
  StartedServer(StartedServer&&) noexcept;
  ~StartedServer();

  const char* host() const { return "127.0.0.1"; }
  match::ServerPorts ports() const;
  const process::Child& child() const { return *child_; }
  /// What it has printed so far.
  match::ServerNews news() const { return output_->news(); }

 private:
  StartedServer();

  std::unique_ptr<ScratchFolder> folder_;
  std::vector<process::ReservedPort> reserved_;
  std::shared_ptr<match::ServerOutput> output_ = std::make_shared<match::ServerOutput>();
  std::unique_ptr<process::ProcessHost> host_;
  std::shared_ptr<process::Child> child_;
};

}  // namespace cls::orchestration::checks
