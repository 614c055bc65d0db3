// The Playmaker of a `run:` side as a process of ours.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/result.h"
#include "orchestration/match/options/endpoint.h"
#include "orchestration/match/options/run_command.h"
#include "orchestration/match/result/match_result.h"
#include "orchestration/process/ports.h"
#include "orchestration/process/process_host.h"

namespace cls::orchestration::match {

/// What to tell of a child that ended, or that is about to be ended.
ProcessFailure failure_of(const process::Child& child);

/// The line for result.json's list of processes; asks for the CPU time.
ProcessResult result_of(const process::Child& child);

/// Starts the command on a port of its own.
class PlaymakerProgram {
 public:
  /// `values.port` is chosen here. The log goes into `folder`.
  static base::Result<std::unique_ptr<PlaymakerProgram>> start(process::ProcessHost& host,
                                                               const Endpoint& endpoint,
                                                               RunValues values,
                                                               const std::filesystem::path& folder,
                                                               std::vector<int> cpus = {});

  int port() const { return port_.number(); }
  const process::Child& child() const { return *child_; }
  bool ended() const { return process::has_ended(child_->status()); }

  /// What its open ports have to do with it not answering: "" or "; it listens on port 50051, not
  /// on 21234".
  std::string port_hint() const;

 private:
  explicit PlaymakerProgram(process::ReservedPort port) : port_(std::move(port)) {}

  process::ReservedPort port_;
  std::shared_ptr<process::Child> child_;
};

}  // namespace cls::orchestration::match
