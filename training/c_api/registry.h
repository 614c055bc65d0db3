// Pools by handle.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <memory>

#include "training/pool/pool.h"

namespace cls::training {

struct RegisteredPool {
  Pool pool;
  pid_t process;                               ///< that created it
  std::atomic_flag in_use = ATOMIC_FLAG_INIT;  ///< by a call
};

/// Handles are never used again. The registry is not destroyed at exit: after fork() a child must
/// not wait for threads that it does not have.
std::uint64_t register_pool(PoolConfig config);

/// Null for unknown handles.
std::shared_ptr<RegisteredPool> find_pool(std::uint64_t handle);

void forget_pool(std::uint64_t handle);

}  // namespace cls::training
