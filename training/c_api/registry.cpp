// The table of pools.
#include "training/c_api/registry.h"

#include <unistd.h>

#include <map>
#include <mutex>
#include <utility>

namespace cls::training {
namespace {

struct Registry {
  std::mutex mutex;
  std::map<std::uint64_t, std::shared_ptr<RegisteredPool>> pools;
  std::uint64_t next = 1;
};

Registry& registry() {
  static Registry& instance = *new Registry;
  return instance;
}

}  // namespace

std::uint64_t register_pool(PoolConfig config) {
  // In two steps: the pool's threads hold its address.
  auto entry =
      std::shared_ptr<RegisteredPool>(new RegisteredPool{Pool(std::move(config)), ::getpid()});
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  const std::uint64_t handle = all.next++;
  all.pools.emplace(handle, std::move(entry));
  return handle;
}

std::shared_ptr<RegisteredPool> find_pool(std::uint64_t handle) {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  const auto found = all.pools.find(handle);
  return found == all.pools.end() ? nullptr : found->second;
}

void forget_pool(std::uint64_t handle) {
  std::shared_ptr<RegisteredPool> last;  // destroyed after the lock
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  const auto found = all.pools.find(handle);
  if (found == all.pools.end()) return;
  last = std::move(found->second);
  all.pools.erase(found);
}

}  // namespace cls::training
