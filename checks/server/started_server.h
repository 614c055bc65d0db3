// Starts a soccer server for a check: on free ports, in a folder of its own.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "match/programs/server_plan.h"
#include "match/server/server_output.h"
#include "match/terms/server_choice.h"
#include "process/ports.h"
#include "process/process_host.h"

namespace cls::checks {

/// The destructor terminates the server.
class StartedServer {
 public:
  /// `choice` is not an address; embedded: `own_program server`. Synchronous mode with these
  /// parameters; its logs are in `folder`. Returns an error if it cannot be started; does not wait
  /// for it.
  static base::Result<StartedServer> start(const match::ServerChoice& choice,
                                           const std::string& own_program,
                                           const soccer::ServerParams& params,
                                           const std::filesystem::path& folder);

  const char* host() const { return "127.0.0.1"; }
  match::ServerPorts ports() const;
  const process::Child& child() const { return *child_; }
  /// Status from its output so far.
  match::ServerStatus status() const { return output_->status(); }

 private:
  StartedServer() = default;

  std::vector<process::ReservedPort> reserved_;
  std::shared_ptr<match::ServerOutput> output_ = std::make_shared<match::ServerOutput>();
  std::unique_ptr<process::ProcessHost> host_;
  std::shared_ptr<process::Child> child_;
};

}  // namespace cls::checks
