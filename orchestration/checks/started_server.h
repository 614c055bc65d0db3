// A soccer server that is started to be looked at: on free ports, in a folder of its own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "orchestration/process/ports.h"
#include "orchestration/process/process_host.h"
#include "orchestration/server_choice.h"
#include "orchestration/server_command.h"
#include "orchestration/server_output.h"
#include "soccer/result.h"

namespace cls::orchestration {

class ScratchFolder;

/// Ended, and its folder removed, with the object.
class StartedServer {
 public:
  /// `choice` is no address; embedded: `own_program server`. Synchronous mode, with these
  /// parameters. The error says why it cannot be started; that it stays alive is not waited for.
  static soccer::Result<StartedServer> start(const ServerChoice& choice,
                                             const std::string& own_program,
                                             const soccer::ServerParams& params);
  StartedServer(StartedServer&&) noexcept;
  ~StartedServer();

  const char* host() const { return "127.0.0.1"; }
  ServerPorts ports() const;
  const Child& child() const { return *child_; }
  /// What it has printed so far.
  ServerNews news() const { return output_->news(); }

 private:
  StartedServer();

  std::unique_ptr<ScratchFolder> folder_;
  std::vector<ReservedPort> reserved_;
  std::shared_ptr<ServerOutput> output_ = std::make_shared<ServerOutput>();
  std::unique_ptr<ProcessHost> host_;
  std::shared_ptr<Child> child_;
};

}  // namespace cls::orchestration
