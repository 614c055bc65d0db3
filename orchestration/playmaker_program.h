// The Playmaker of a `run:` side as a process of ours.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "orchestration/endpoint.h"
#include "orchestration/match_result.h"
#include "orchestration/process/ports.h"
#include "orchestration/process/process_host.h"
#include "orchestration/run_command.h"
#include "soccer/result.h"

namespace cls::orchestration {

/// What to tell of a child that ended, or that is about to be ended.
ProcessFailure failure_of(const Child& child);

/// The line for result.json's list of processes; asks for the CPU time.
ProcessResult result_of(const Child& child);

/// Starts the command on a port of its own.
class PlaymakerProgram {
 public:
  /// `values.port` is chosen here. The log goes into `folder`.
  static soccer::Result<std::unique_ptr<PlaymakerProgram>> start(
      ProcessHost& host, const Endpoint& endpoint, RunValues values,
      const std::filesystem::path& folder, std::vector<int> cpus = {});

  int port() const { return port_.number(); }
  const Child& child() const { return *child_; }
  bool ended() const { return has_ended(child_->status()); }

  /// What its open ports have to do with it not answering: "" or "; it listens on port 50051, not
  /// on 21234".
  std::string port_hint() const;

 private:
  explicit PlaymakerProgram(ReservedPort port) : port_(std::move(port)) {}

  ReservedPort port_;
  std::shared_ptr<Child> child_;
};

}  // namespace cls::orchestration
