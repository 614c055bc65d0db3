// statvfs, stat of each file, and fallocate of a file without a name.
#include "base/io/disk_space.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

namespace cls::base {

namespace fs = std::filesystem;

std::uint64_t free_bytes(const fs::path& path) {
  struct statvfs space = {};
  if (::statvfs(path.c_str(), &space) != 0) return 0;
  return std::uint64_t{space.f_bavail} * space.f_frsize;
}

dev_t device_of(const fs::path& path) {
  struct stat status = {};
  return ::stat(path.c_str(), &status) == 0 ? status.st_dev : 0;
}

std::uint64_t bytes_below(const std::vector<fs::path>& folders) {
  constexpr std::uint64_t kBlock = 512;
  std::set<std::pair<dev_t, ino_t>> counted;
  std::uint64_t bytes = 0;
  for (const fs::path& folder : folders) {
    std::error_code code;
    constexpr auto kSkip = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator entry(folder, kSkip, code), end; !code && entry != end;
         entry.increment(code)) {
      struct stat status = {};
      if (::lstat(entry->path().c_str(), &status) != 0) continue;
      if (!counted.emplace(status.st_dev, status.st_ino).second) continue;
      bytes += static_cast<std::uint64_t>(status.st_blocks) * kBlock;
    }
  }
  return bytes;
}

void reserve_space(const fs::path& file, std::uint64_t bytes) {
  constexpr std::uint64_t kShare = 8;
  const UniqueFd fd(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  const auto size = static_cast<off_t>(std::min(bytes, free_bytes(file) / kShare));
  if (fd && ::fallocate(fd.get(), FALLOC_FL_KEEP_SIZE, 0, size) != 0) return;
}

void release_space(const fs::path& file) {
  struct stat status = {};
  if (::stat(file.c_str(), &status) != 0) return;
  if (::truncate(file.c_str(), status.st_size) != 0) return;
}

KeptSpace::KeptSpace(const fs::path& folder, std::uint64_t bytes)
    : file_(::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600)) {
  constexpr std::uint64_t kShare = 4;
  const std::uint64_t size = std::min(bytes, free_bytes(folder) / kShare);
  if (!file_ || ::fallocate(file_.get(), 0, 0, static_cast<off_t>(size)) != 0) file_.reset();
}

}  // namespace cls::base
