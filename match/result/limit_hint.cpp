// Finds the limit, and words it.
#include "match/result/limit_hint.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/text/byte_size.h"

namespace cls::match {
namespace {

// What programs print when they get no memory: C, C++, Python, Java, JavaScript, Go and Rust, dd.
constexpr std::array<std::string_view, 8> kOutOfMemory = {
    "Cannot allocate memory", "bad_alloc",     "MemoryError",       "OutOfMemoryError",
    "out of memory",          "Out of memory", "memory allocation", "memory exhausted"};

bool says_out_of_memory(const process::Child& child) {
  const std::vector<std::string> lines = child.last_lines();
  return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return std::any_of(kOutOfMemory.begin(), kOutOfMemory.end(), [&](std::string_view words) {
      return line.find(words) != std::string::npos;
    });
  });
}

}  // namespace

std::string limit_hint(const process::Child& child) {
  const process::ResourceLimits& limits = child.plan().limits;
  if (child.status().at_cpu_limit) {
    return fmt::format(
        "; a process of {} had used the {} s of CPU time that --max-cpu allows: raise or omit the "
        "limit",
        child.plan().name, limits.cpu_seconds);
  }
  if (limits.memory != 0 && says_out_of_memory(child)) {
    return fmt::format(
        "; a process of {} needed more than the {} of memory that --max-memory allows: raise or "
        "omit the limit",
        child.plan().name, base::byte_size_text(limits.memory));
  }
  return {};
}

}  // namespace cls::match
