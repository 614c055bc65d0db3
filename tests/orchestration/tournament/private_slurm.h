// A Slurm of a test's own: controller and two nodes on this machine, without systemd and root.
#pragma once

#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "orchestration/process/ports.h"
#include "tests/orchestration/process/test_guard.h"
#include "tests/support/command.h"
#include "tests/support/temporary_folder.h"

namespace cls::orchestration::tournament {

/// Daemons on loopback ports that nobody else has, with configuration, keys and state in a folder
/// of their own. All of them, and all that their jobs started, end with this object, and with this
/// process in whatever way it ends.
class PrivateSlurm {
 public:
  /// What of slurm-wlm and munge is missing on this machine; empty when nothing is.
  static std::string missing();

  /// Starts the daemons. Arrays have `max_array_size` tasks at most, nodes two processors.
  explicit PrivateSlurm(int max_array_size);

  /// Both nodes are ready for jobs; false after a generous limit.
  bool wait_until_ready();

  /// Ends the daemon of a node with SIGKILL; its tasks go on.
  void kill_daemon(int node);
  /// Ends the daemon of a node and everything it started, as a power cut does.
  void cut_power(int node);
  /// Starts the daemon of a node (again).
  void start_node(int node);

  /// Environment lines for clients.
  std::vector<std::string> environment() const;
  /// A client, such as {"squeue", "--noheader"}: what it prints.
  std::string ask(std::vector<std::string> words) const;

  /// Ends of the daemons' logs, for messages of failed tests.
  std::string logs() const;

 private:
  std::shared_ptr<process::Child> start(const std::string& name, std::vector<std::string> argv);
  void write_files();

  tests::TemporaryFolder folder_;
  int max_array_size_;
  std::vector<process::ReservedPort> ports_;  // of the controller and the nodes
  MarkedHost host_;
  std::shared_ptr<process::Child> munged_;
  std::shared_ptr<process::Child> controller_;
  std::array<std::shared_ptr<process::Child>, 2> nodes_;
};

}  // namespace cls::orchestration::tournament
