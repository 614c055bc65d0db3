// One test at a time on this machine for what needs fixed ports.
#pragma once

namespace cls::tests {

/// Held by one process at a time; the others wait in the constructor. Gone with its process.
class PortLock {
 public:
  PortLock();
  ~PortLock();
  PortLock(const PortLock&) = delete;
  PortLock& operator=(const PortLock&) = delete;

 private:
  int socket_;
};

}  // namespace cls::tests
