// Implementation of ProcessHost: records of children, and the thread that reads their output.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "base/system/unique_fd.h"
#include "process/output_log.h"
#include "process/packet.h"
#include "process/process_host.h"

namespace cls::process {

/// One child; all but `plan` under the core's mutex.
struct ChildRecord {
  CommandPlan plan;
  base::UniqueFd control;  ///< to its keeper
  base::UniqueFd output;
  OutputLog log;
  Child::Status status;
  std::optional<KeeperReport> first_report;  ///< kStarted or kFailed
  double cpu_seconds = 0.0;
  double delayed_seconds = 0.0;
  std::uint64_t usage_answers = 0;

  /// Sends a request to the keeper.
  void ask(const KeeperRequest& request);
};

/// Shared by the host and its children, because a Child may outlive the host.
struct ProcessHostCore {
  /// `wake_event` is an eventfd.
  ProcessHostCore(std::size_t log_limit, base::UniqueFd wake_event);
  ~ProcessHostCore();

  void add(std::shared_ptr<ChildRecord> record);
  /// Makes the thread read its list again.
  void wake() const;
  /// Stops the thread; every child counts as gone afterwards.
  void stop();

  const std::size_t log_limit;
  mutable std::mutex mutex;
  mutable std::condition_variable changed;
  std::atomic<std::uint64_t> changes{0};
  std::vector<std::shared_ptr<ChildRecord>> records;

 private:
  void run();
  void poll_child(ChildRecord& record);
  void mark_gone(ChildRecord& record);
  void handle_report(ChildRecord& record);
  void notify_change();

  base::UniqueFd wake_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace cls::process
