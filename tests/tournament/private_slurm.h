// A private Slurm for a test: controller and two nodes on this host, without systemd and root.
#pragma once

#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "process/ports.h"
#include "tests/process/test_guard.h"
#include "tests/support/command.h"
#include "tests/support/temporary_folder.h"

namespace cls::tournament {

/// Daemons on unused loopback ports, with configuration, keys and state in a temporary folder. The
/// daemons and all processes of their jobs end with this object, and with this process, even if it
/// is killed.
class PrivateSlurm {
 public:
  /// The missing programs of slurm-wlm and munge; empty when all are installed.
  static std::string missing();

  /// Starts the daemons. Arrays have at most `max_array_size` tasks, nodes two CPUs.
  explicit PrivateSlurm(int max_array_size);

  /// Waits until both nodes accept jobs; false after a timeout.
  bool wait_until_ready();

  /// Kills the daemon of a node with SIGKILL; its tasks continue.
  void kill_daemon(int node);
  /// Kills the daemon of a node and all its processes, as a power cut does.
  void cut_power(int node);
  /// Starts the daemon of a node (again).
  void start_node(int node);

  /// Environment lines for clients.
  std::vector<std::string> environment() const;
  /// Runs a client, such as {"squeue", "--noheader"}, and returns its output.
  std::string run(std::vector<std::string> argv) const;

  /// Ends of the daemons' logs, for messages of failed tests.
  std::string logs() const;

 private:
  std::shared_ptr<process::Child> start(const std::string& name, std::vector<std::string> argv);
  void write_files();

  tests::TemporaryFolder folder_;
  int max_array_size_;
  std::vector<process::ReservedPort> ports_;  // of the controller and the nodes
  process::MarkedHost host_;
  std::shared_ptr<process::Child> munged_;
  std::shared_ptr<process::Child> controller_;
  std::array<std::shared_ptr<process::Child>, 2> nodes_;
};

}  // namespace cls::tournament
