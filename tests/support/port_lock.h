// A host-wide lock for tests that use fixed ports.
#pragma once

namespace cls::tests {

/// Held by one process at a time, any number of times; the constructor waits. Released when its
/// process exits. Used on one thread.
class PortLock {
 public:
  PortLock();
  ~PortLock();
  PortLock(const PortLock&) = delete;
  PortLock& operator=(const PortLock&) = delete;

 private:
  int socket_ = -1;
};

}  // namespace cls::tests
