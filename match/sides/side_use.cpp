// Cheap looks now and then, and an exact one when they show much.
#include "match/sides/side_use.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/io/disk_space.h"
#include "base/system/control_group.h"
#include "base/system/host.h"
#include "base/text/byte_size.h"
#include "process/program_use.h"

namespace cls::match {
namespace {

constexpr std::chrono::milliseconds kInterval{500};
// Of walks through the folders, whatever the disks say: what others free hides what a side writes.
constexpr std::chrono::seconds kWalkInterval{5};
// What a match needs for its own files.
constexpr std::uint64_t kNeededSpace = std::uint64_t{16} << 20;

// In whole megabytes, where there are some.
std::string size_text(std::uint64_t bytes) {
  constexpr int kMegabyte = 20;
  return base::byte_size_text(bytes >> kMegabyte == 0 ? bytes : bytes >> kMegabyte << kMegabyte);
}

std::uint64_t memory_of_host() {
  static const std::uint64_t bytes = [] {
    const auto installed = static_cast<std::uint64_t>(base::this_machine().memory_bytes);
    const auto allowed = base::memory_kills().limit;
    return allowed ? std::min(installed, *allowed) : installed;
  }();
  return bytes;
}

std::uint64_t two_fifths(std::uint64_t bytes) { return bytes / 5 * 2; }

}  // namespace

SideUse::SideUse(soccer::Side side, const SideLimits& limits)
    : programs_(fmt::format("{} ", side_name(side))), limits_(limits) {
  if (limits_.memory == 0) limits_.memory = two_fifths(memory_of_host());
}

void SideUse::begin(std::vector<std::filesystem::path> folders) {
  std::ranges::sort(folders);
  folders.erase(std::unique(folders.begin(), folders.end()), folders.end());
  folders_ = std::move(folders);

  bytes_at_start_ = base::bytes_below(folders_);
  for (const auto& folder : folders_) {
    if (!devices_.insert(base::device_of(folder)).second) continue;
    const std::uint64_t free = base::free_bytes(folder);
    disks_.push_back({folder, free, free, free});
  }
  next_ = Clock::now() + kInterval;
  next_walk_ = Clock::now() + kWalkInterval;
}

std::string SideUse::excess(bool at_once) {
  if (folders_.empty() || (!at_once && Clock::now() < next_)) return {};
  std::string text = excess_of_processor_and_memory();
  if (text.empty()) text = excess_of_disk();
  next_ = Clock::now() + kInterval;
  return text;
}

std::string SideUse::excess_of_processor_and_memory() const {
  const process::ProgramUse use = process::use_of_programs(programs_, limits_.memory);
  if (use.processes > limits_.processes) {
    return fmt::format(
        "its programs are {} processes and threads, more than the {} that --side-processes allows",
        use.processes, limits_.processes);
  }
  if (limits_.memory != 0 && use.memory > limits_.memory) {
    return fmt::format("its programs use {} of memory, more than the {} that --side-memory allows",
                       size_text(use.memory), size_text(limits_.memory));
  }
  return {};
}

bool SideUse::Disk::is_full() const {
  constexpr std::uint64_t kShare = 4;
  return free < std::min(kNeededSpace, free_at_start / kShare);
}

// Others fill disks, too: only a walk through its folders shows what the side has written.
bool SideUse::must_measure_disk() const {
  constexpr std::uint64_t kShare = 8;
  return Clock::now() >= next_walk_ || std::ranges::any_of(disks_, [this](const Disk& disk) {
           const bool less = disk.free + limits_.disk / kShare < disk.free_when_measured;
           return less || (disk.is_full() && disk.free < disk.free_when_measured);
         });
}

std::uint64_t SideUse::written() {
  next_walk_ = Clock::now() + kWalkInterval;
  for (Disk& disk : disks_) disk.free_when_measured = disk.free;
  const std::uint64_t now =
      base::bytes_below(folders_) + process::unnamed_bytes_of_programs(programs_, devices_);
  return now - std::min(now, bytes_at_start_);
}

std::string SideUse::excess_of_disk() {
  for (Disk& disk : disks_) disk.free = base::free_bytes(disk.folder);
  if (!must_measure_disk()) return {};

  const std::uint64_t bytes = written();
  if (bytes > limits_.disk) {
    return fmt::format("its programs wrote {} to disk, more than the {} that --side-disk allows",
                       size_text(bytes), size_text(limits_.disk));
  }

  for (const Disk& disk : disks_) {
    const std::uint64_t gone = disk.free_at_start - std::min(disk.free, disk.free_at_start);
    if (!disk.is_full() || bytes < gone / 2) continue;
    return fmt::format("its programs filled the disk: they wrote {}, and {} are left at {}",
                       size_text(bytes), size_text(disk.free), disk.folder.string());
  }
  return {};
}

}  // namespace cls::match
