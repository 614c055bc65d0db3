// Replaces operator new by a counting one in programs that link this file.
#include "tests/support/allocation_count.h"

#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/support/sanitizers.h"

namespace {

std::atomic<std::int64_t> count{0};

}  // namespace

#if !CLS_SANITIZED
void* operator new(std::size_t size) {
  count.fetch_add(1, std::memory_order_relaxed);
  if (void* memory = std::malloc(size != 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

namespace cls::tests {

bool counts_allocations() { return CLS_SANITIZED == 0; }

std::int64_t allocation_count() { return count.load(std::memory_order_relaxed); }

}  // namespace cls::tests
