// Reads the files of the groups from the innermost to the root: each limits those inside of it.
#include "base/system/control_group.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/byte_size.h"
#include "base/text/number_text.h"
#include "base/text/split.h"

namespace cls::base {
namespace {

namespace fs = std::filesystem;

// Version 1 limits memory to this if it has no limit.
constexpr std::uint64_t kNoMemoryLimit = std::uint64_t{1} << 60;

// The folders of the groups that a controller of version 1, or version 2 ("") shows, innermost
// first. In a container the path is often that of the host, and its root the group itself.
std::vector<fs::path> group_folders(const ControlGroupFiles& files, std::string_view controller) {
  std::ifstream lines(files.groups_of_process);
  std::string path;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(':');
    const std::size_t second = line.find(':', first + 1);
    if (second == line.npos) continue;
    const std::string_view names = std::string_view(line).substr(first + 1, second - first - 1);
    const auto listed = split(names, ',');
    if (std::ranges::find(listed, controller) != listed.end()) path = line.substr(second + 1);
  }
  if (path.empty()) return {};

  const fs::path root = files.root / controller;
  std::vector<fs::path> folders;
  for (fs::path group = fs::path(path).relative_path(); !group.empty();
       group = group.parent_path()) {
    folders.push_back(root / group);
  }
  folders.push_back(root);
  return folders;
}

// The first line of a file; empty without it.
std::string line_of(const fs::path& file) {
  std::ifstream lines(file);
  std::string line;
  std::getline(lines, line);
  return line;
}

// Nothing for "max".
std::optional<std::int64_t> parse_count(std::string_view text) {
  const auto number = parse_number(text);
  if (!number || std::abs(*number) > 9e18) return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

std::optional<std::int64_t> number_in(const fs::path& file) { return parse_count(line_of(file)); }

// The value behind a name in a file of lines "oom_kill 3".
std::int64_t value_of(const fs::path& file, std::string_view name) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t space = line.find(' ');
    if (std::string_view(line).substr(0, space) != name || space == line.npos) continue;
    return parse_count(std::string_view(line).substr(space + 1)).value_or(0);
  }
  return 0;
}

void lower(std::optional<double>& least, double quota, double period) {
  if (quota <= 0.0 || period <= 0.0) return;
  least = std::min(least.value_or(quota / period), quota / period);
}

}  // namespace

std::optional<int> processor_quota(const ControlGroupFiles& files) {
  std::optional<double> least;
  for (const fs::path& group : group_folders(files, "")) {
    const std::string text = line_of(group / "cpu.max");  // "50000 100000", "max 100000"
    const std::vector<std::string_view> fields = split(text, ' ');
    if (fields.size() != 2) continue;
    const auto quota = parse_count(fields[0]);
    const auto period = parse_count(fields[1]);
    if (quota && period) lower(least, double(*quota), double(*period));
  }
  for (const fs::path& group : group_folders(files, "cpu")) {
    const auto quota = number_in(group / "cpu.cfs_quota_us");
    const auto period = number_in(group / "cpu.cfs_period_us");
    if (quota && period) lower(least, double(*quota), double(*period));
  }

  if (!least) return std::nullopt;
  return std::max(1, static_cast<int>(std::ceil(*least - 1e-9)));
}

std::optional<std::int64_t> process_limit(const ControlGroupFiles& files) {
  std::optional<std::int64_t> least;
  for (const char* controller : {"", "pids"}) {
    for (const fs::path& group : group_folders(files, controller)) {
      const auto limit = number_in(group / "pids.max");
      if (limit) least = std::min(least.value_or(*limit), *limit);
    }
  }
  return least;
}

MemoryKills memory_kills(const ControlGroupFiles& files) {
  MemoryKills kills;
  const auto add = [&kills](const fs::path& events, const fs::path& limit_file) {
    kills.count += value_of(events, "oom_kill");
    const auto limit = number_in(limit_file);
    if (!limit || *limit <= 0 || std::uint64_t(*limit) >= kNoMemoryLimit) return;
    kills.limit = std::min(kills.limit.value_or(kNoMemoryLimit), std::uint64_t(*limit));
  };
  for (const fs::path& group : group_folders(files, "")) {
    add(group / "memory.events", group / "memory.max");
  }
  for (const fs::path& group : group_folders(files, "memory")) {
    add(group / "memory.oom_control", group / "memory.limit_in_bytes");
  }
  return kills;
}

namespace {

std::atomic<std::int64_t> noted_kills{0};

}  // namespace

void note_memory_kills() { noted_kills = memory_kills().count; }

std::string memory_kill_text() {
  const MemoryKills now = memory_kills();
  if (now.count <= noted_kills) return {};
  const std::string limit =
      now.limit ? fmt::format(": its control group allows {}", byte_size_text(*now.limit)) : "";
  return "the kernel killed a process for want of memory" + limit;
}

}  // namespace cls::base
