// Measures what the programs of a side use of this host, and compares it with their limits.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "match/terms/side_limits.h"
#include "soccer/side.h"

namespace cls::match {

/// Of the programs that cls has started for a side. Used by the match's thread only.
class SideUse {
 public:
  SideUse(soccer::Side side, const SideLimits& limits);

  /// Before the first program starts: they may write into these folders.
  void begin(std::vector<std::filesystem::path> folders);

  /// The limit that they exceed: "its programs wrote 1200M to disk, more than the 1G that
  /// --side-disk allows". Empty: none, or measured less than half a second ago, unless `at_once`.
  std::string excess(bool at_once);

 private:
  using Clock = std::chrono::steady_clock;

  /// A file system that they can fill.
  struct Disk {
    std::filesystem::path folder;
    std::uint64_t free_at_start = 0;
    std::uint64_t free_when_measured = 0;
    std::uint64_t free = 0;

    bool is_full() const;
  };

  std::string excess_of_processor_and_memory() const;
  std::string excess_of_disk();
  bool must_measure_disk() const;
  std::uint64_t written();

  std::string programs_;  ///< how their names begin
  SideLimits limits_;
  std::vector<std::filesystem::path> folders_;
  std::vector<Disk> disks_;
  std::set<dev_t> devices_;
  std::uint64_t bytes_at_start_ = 0;
  Clock::time_point next_;
  Clock::time_point next_walk_;
};

}  // namespace cls::match
