// Inside of ProcessHost: the records of children and the thread that reads what they say.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "orchestration/process/output_log.h"
#include "orchestration/process/packet.h"
#include "orchestration/process/process_host.h"
#include "orchestration/process/unique_fd.h"

namespace cls::orchestration::process {

/// One child; all but `plan` under the core's mutex.
struct ChildRecord {
  CommandPlan plan;
  UniqueFd control;  ///< to its keeper
  UniqueFd output;
  OutputLog log;
  Child::Status status;
  std::optional<KeeperReport> first_report;  ///< kStarted or kFailed
  double cpu_seconds = 0.0;
  std::uint64_t usage_answers = 0;

  /// Sends a request to end the child.
  void ask(const KeeperRequest& request);
};

/// Shared by the host and its children, so that a child may be asked when the host is gone.
struct ProcessHostCore {
  explicit ProcessHostCore(std::size_t log_limit);
  ~ProcessHostCore();

  void add(std::shared_ptr<ChildRecord> record);
  /// Makes the thread look at its list anew.
  void wake() const;
  /// Ends the thread; every child counts as gone from then on.
  void stop();

  const std::size_t log_limit;
  mutable std::mutex mutex;
  mutable std::condition_variable changed;
  std::atomic<std::uint64_t> changes{0};
  std::vector<std::shared_ptr<ChildRecord>> records;

 private:
  void run();
  void tend(ChildRecord& record);
  void bury(ChildRecord& record);
  void take_report(ChildRecord& record);
  void note_change();

  UniqueFd wake_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace cls::orchestration::process
