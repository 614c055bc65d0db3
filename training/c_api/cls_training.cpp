// The C interface: knows pools by handle; checks pointers and sizes; catches everything.
#include "training/c_api/cls_training.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "base/system/version.h"
#include "base/text/json.h"
#include "training/c_api/world_view.h"
#include "training/pool/specification.h"

namespace cls::training {
namespace {

static_assert(CLS_TRAINING_INTERNAL == static_cast<int>(Code::kInternal));
static_assert(CLS_TRAINING_BAD_ACTION == static_cast<int>(Code::kBadAction));
static_assert(CLS_TRAINING_FORKED == static_cast<int>(Code::kForked));
static_assert(CLS_TRAINING_STOPPED == static_cast<int>(Status::kStopped));

std::string& last_error() {
  thread_local std::string text;
  return text;
}

int fail(Code code, std::string_view text) noexcept {
  try {
    last_error() = text;
    for (char& c : last_error()) {
      if (c == '\n' || c == '\r') c = ' ';
    }
  } catch (...) {
    last_error().clear();
  }
  return static_cast<int>(code);
}

int result(const Outcome& outcome) {
  return outcome.ok() ? static_cast<int>(Code::kOk) : fail(outcome.code, outcome.text);
}

/// Runs `body`, which returns an Outcome, and turns exceptions into codes.
template <typename Body>
int guarded(Body body) noexcept {
  try {
    return result(body());
  } catch (const std::exception& error) {
    return fail(Code::kInternal, error.what());
  } catch (...) {
    return fail(Code::kInternal, "unknown exception");
  }
}

struct RegisteredPool {
  Pool pool;
  pid_t process;                               ///< that created it
  std::atomic_flag in_use = ATOMIC_FLAG_INIT;  ///< by a call
};

/// Pools by handle. Handles are never used again. The registry is not destroyed at exit: after
/// fork() a child must not wait for threads that it does not have.
struct Registry {
  std::mutex mutex;
  std::map<std::uint64_t, std::shared_ptr<RegisteredPool>> pools;
  std::uint64_t next = 1;
};

Registry& registry() {
  static Registry& instance = *new Registry;
  return instance;
}

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

/// Null for unknown handles.
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

struct Release {
  std::atomic_flag& flag;
  ~Release() { flag.clear(); }
};

/// Runs `body` on the pool.
template <typename Body>
int with_pool(std::uint64_t handle, Body body) noexcept {
  return guarded([&]() -> Outcome {
    const std::shared_ptr<RegisteredPool> entry = find_pool(handle);
    if (entry == nullptr) {
      return {Code::kBadHandle,
              "there is no pool " + std::to_string(handle) + ", or it was closed"};
    }
    if (entry->process != ::getpid()) {
      return {Code::kForked, "the pool belongs to the parent process; create one after the fork"};
    }
    if (entry->in_use.test_and_set()) {
      return {Code::kBadOrder, "another thread uses the pool; call it from one thread at a time"};
    }
    const Release release{entry->in_use};
    return body(entry->pool);
  });
}

Outcome null_pointer(std::string_view name) {
  return {Code::kBadPointer, "'" + std::string(name) + "' is NULL"};
}

Outcome write_text(const std::string& text, char* out, size_t capacity, size_t* length) {
  if (length == nullptr) return null_pointer("length");
  if (out == nullptr && capacity > 0) return null_pointer("out");

  *length = text.size();
  if (capacity > 0) {
    const size_t count = std::min(capacity - 1, text.size());
    std::memcpy(out, text.data(), count);
    out[count] = '\0';
  }

  if (text.size() < capacity) return {};
  return {Code::kSmallBuffer,
          "the text has " + std::to_string(text.size()) + " bytes and a final 0"};
}

/// Checks one buffer and takes its pointer.
class Binder {
 public:
  template <typename T>
  void take(const char* name, const cls_training_buffer& buffer, std::uint64_t count, bool needed,
            T*& out) {
    out = nullptr;
    if (!outcome.ok()) return;

    if (buffer.data == nullptr) {
      if (needed && count > 0) outcome = null_pointer(name);
      return;
    }

    if (buffer.count != count) {
      outcome = {Code::kBadSize, std::string("'") + name + "' must have " + std::to_string(count) +
                                     " elements, not " + std::to_string(buffer.count)};
      return;
    }

    if (reinterpret_cast<std::uintptr_t>(buffer.data) % alignof(T) != 0) {
      outcome = {Code::kBadPointer, std::string("'") + name + "' is not aligned"};
      return;
    }

    if (count > 0) out = static_cast<T*>(buffer.data);
  }

  Outcome outcome;
};

// The struct of the header has the arrays of the table.
constexpr std::size_t kArrayOffsets[] = {
#define CLS_TRAINING_ARRAY(type, name, count, needed) offsetof(cls_training_buffers, name),
#include "training/pool/arrays.inc"
    sizeof(cls_training_buffers)};

constexpr bool has_arrays_in_order() {
  std::size_t next = sizeof(cls_training_buffers::struct_size);
  for (const std::size_t offset : kArrayOffsets) {
    if (std::exchange(next, next + sizeof(cls_training_buffer)) != offset) return false;
  }
  return true;
}
static_assert(has_arrays_in_order());

Outcome bind(Pool& pool, const cls_training_buffers& in) {
  const Setup& setup = pool.setup();
  const std::uint64_t worlds = pool.size();
  const std::uint64_t rows = worlds * setup.agent_count();
  const std::uint64_t features = setup.feature_count();
  const std::uint64_t ids = setup.id_count();
  const std::uint64_t width = setup.id_width();
  const std::uint64_t values = setup.value_count();
  const std::uint64_t states = setup.state_columns.size();
  constexpr std::uint64_t terms = kRewardTerms;
  const std::uint64_t experts = setup.expert ? rows : 0;
  const bool resets = pool.config().autoreset != Autoreset::kDisabled;

  Buffers out;
  Binder binder;
#define CLS_TRAINING_ARRAY(type, name, count, needed) \
  binder.take(#name, in.name, count, needed, out.name);
#include "training/pool/arrays.inc"

  if (binder.outcome.ok()) pool.bind(out);
  return binder.outcome;
}

}  // namespace
}  // namespace cls::training

// The functions of the header, outside all namespaces.
namespace engine = cls::training;
using engine::Code;
using engine::guarded;
using engine::null_pointer;
using engine::Outcome;
using engine::Pool;
using engine::with_pool;

// Defined where the mathematical library is part of the file (packaging/embedded_sleef.cpp): why it
// cannot be used, or nullptr.
extern "C" __attribute__((weak)) const char* cls_math_library_fault();

namespace {

Outcome check_math_library() {
  const char* const fault = cls_math_library_fault == nullptr ? nullptr : cls_math_library_fault();
  return fault == nullptr ? Outcome{} : Outcome{Code::kInternal, fault};
}

Outcome check_world(const cls_training_world* world) {
  if (world == nullptr) return null_pointer("world");
  if (world->struct_size == sizeof *world) return {};
  return {Code::kBadSize, "struct_size must be " + std::to_string(sizeof *world)};
}

}  // namespace

int32_t cls_training_abi(void) {
  return guarded(check_math_library) == CLS_TRAINING_OK ? CLS_TRAINING_ABI : 0;
}

const char* cls_training_version(void) { return cls::base::kVersion.data(); }

const char* cls_training_error(void) { return engine::last_error().c_str(); }

int cls_training_catalog(char* out, size_t capacity, size_t* length) {
  return guarded(
      [&] { return engine::write_text(engine::catalog().dump(), out, capacity, length); });
}

int cls_training_create(const char* config_json, uint64_t* pool) {
  return guarded([&]() -> Outcome {
    if (config_json == nullptr) return null_pointer("config_json");
    if (pool == nullptr) return null_pointer("pool");
    if (Outcome usable = check_math_library(); !usable.ok()) return usable;
    auto config = engine::parse_pool_config(config_json);
    if (!config) return {Code::kBadConfig, config.error().message};
    *pool = engine::register_pool(std::move(*config));
    return {};
  });
}

int cls_training_spec(uint64_t handle, char* out, size_t capacity, size_t* length) {
  return with_pool(handle, [&](Pool& pool) {
    return engine::write_text(engine::specification(pool).dump(), out, capacity, length);
  });
}

int cls_training_close(uint64_t handle) {
  return with_pool(handle, [&](Pool& pool) {
    Outcome written = pool.finish_recordings();
    engine::forget_pool(handle);
    return written;
  });
}

int cls_training_bind(uint64_t handle, const cls_training_buffers* buffers) {
  return with_pool(handle, [&](Pool& pool) -> Outcome {
    if (buffers == nullptr) return null_pointer("buffers");
    if (buffers->struct_size != sizeof *buffers) {
      return {Code::kBadSize, "struct_size must be " + std::to_string(sizeof *buffers) + ", not " +
                                  std::to_string(buffers->struct_size) +
                                  "; another version of the header?"};
    }
    return engine::bind(pool, *buffers);
  });
}

int cls_training_reset(uint64_t handle, const uint8_t* mask, const uint64_t* seeds,
                       uint64_t count) {
  return with_pool(handle, [&](Pool& pool) -> Outcome {
    if (seeds == nullptr) return null_pointer("seeds");
    if (count != pool.size()) {
      return {Code::kBadSize, "the pool has " + std::to_string(pool.size()) + " worlds, not " +
                                  std::to_string(count)};
    }
    return pool.reset(mask, seeds);
  });
}

int cls_training_step(uint64_t handle) {
  return with_pool(handle, [](Pool& pool) { return pool.step(); });
}

int cls_training_set_options(uint64_t handle, int64_t env, const char* options_json) {
  return with_pool(handle, [&](Pool& pool) -> Outcome {
    if (options_json == nullptr) return null_pointer("options_json");
    if (env < -1) return {Code::kBadIndex, "no world " + std::to_string(env)};
    return pool.set_options(env, options_json);
  });
}

int cls_training_snapshot(uint64_t handle, uint64_t env, uint64_t* snapshot) {
  return with_pool(handle, [&](Pool& pool) -> Outcome {
    if (snapshot == nullptr) return null_pointer("snapshot");
    return pool.snapshot(env, *snapshot);
  });
}

int cls_training_restore(uint64_t handle, uint64_t env, uint64_t snapshot) {
  return with_pool(handle, [&](Pool& pool) { return pool.restore(env, snapshot); });
}

int cls_training_release(uint64_t handle, uint64_t snapshot) {
  return with_pool(handle, [&](Pool& pool) { return pool.release(snapshot); });
}

int cls_training_fork(uint64_t handle, uint64_t from, uint64_t to) {
  return with_pool(handle, [&](Pool& pool) { return pool.fork(from, to); });
}

int cls_training_record(uint64_t handle, uint64_t env, const char* path) {
  return with_pool(handle, [&](Pool& pool) { return pool.record(env, path); });
}

int cls_training_view(uint64_t handle, uint64_t env, cls_training_world* world) {
  return with_pool(handle, [&](Pool& pool) -> Outcome {
    if (Outcome sized = check_world(world); !sized.ok()) return sized;
    if (env >= pool.size()) return {Code::kBadIndex, "no world " + std::to_string(env)};
    engine::fill_view(pool.episode(env), *world);
    return {};
  });
}

int cls_training_set_state(uint64_t handle, uint64_t env, const cls_training_world* world) {
  return with_pool(handle, [&](Pool& pool) -> Outcome {
    if (Outcome sized = check_world(world); !sized.ok()) return sized;
    const auto start = engine::read_start(*world, pool.setup());
    if (!start) return {Code::kBadConfig, start.error().message};
    return pool.set_state(env, world->seed, *start);
  });
}
