// Space on disks: what is free, what a folder takes, and space that is kept for later.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/system/unique_fd.h"

namespace cls::base {

/// The space that a user without privileges has left where `path` is, in bytes; 0: unknown.
std::uint64_t free_bytes(const std::filesystem::path& path);

/// The device of the file system on which `path` is; 0: unknown.
dev_t device_of(const std::filesystem::path& path);

/// What the files below `folders` take on disk, without following links. A file with several names
/// counts once.
std::uint64_t bytes_below(const std::vector<std::filesystem::path>& folders);

/// Reserves space for a file that is there and will grow, as much of `bytes` as an eighth of what
/// is free, where the file system can; release_space() gives back what the file has not used.
void reserve_space(const std::filesystem::path& file, std::uint64_t bytes);
void release_space(const std::filesystem::path& file);

/// Space that nobody else can fill: a file without a name. As much of `bytes` as a quarter of what
/// is free; without a word none where the file system keeps none.
class KeptSpace {
 public:
  KeptSpace() = default;
  KeptSpace(const std::filesystem::path& folder, std::uint64_t bytes);

  /// From now on others can have it.
  void release() { file_.reset(); }

 private:
  UniqueFd file_;
};

}  // namespace cls::base
