// Memory of calls that a callback service handles itself.
#pragma once

#include <google/protobuf/arena.h>
#include <google/protobuf/message.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace cls::mock_server {

/// Memory of one call, reused: no allocation for each of the many parts of a State.
class Workspace {
 public:
  explicit Workspace(std::size_t size) : block_(size), arena_(block_.data(), block_.size()) {}

  google::protobuf::Message& create(const google::protobuf::Message& prototype) {
    return *prototype.New(&arena_);
  }
  void reset() { arena_.Reset(); }

 private:
  std::vector<char> block_;
  google::protobuf::Arena arena_;
};

/// A State of a busy cycle fits, with its reply. A workspace grows temporarily for a larger one.
constexpr std::size_t kStateMemory = 96 * 1024;

/// Workspaces for calls on several threads.
class WorkspacePool {
 public:
  /// `size`: bytes of each workspace.
  explicit WorkspacePool(std::size_t size) : size_(size) {}
  /// No call may be under way. The lock orders this after them for thread sanitizer, too, which
  /// does not see how gRPC waits for its calls.
  ~WorkspacePool() { const std::lock_guard lock(mutex_); }

  std::unique_ptr<Workspace> acquire() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::make_unique<Workspace>(size_);
    auto workspace = std::move(idle_.back());
    idle_.pop_back();
    return workspace;
  }

  void release(std::unique_ptr<Workspace> workspace) {
    workspace->reset();
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(workspace));
  }

 private:
  std::size_t size_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Workspace>> idle_;
};

}  // namespace cls::mock_server
