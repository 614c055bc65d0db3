// The three system calls of Landlock, for which the C library has no functions.
#include "process/landlock.h"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace cls::process {
namespace {

constexpr std::uint64_t kReading =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kWritingFirst =
    LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR | LANDLOCK_ACCESS_FS_REMOVE_FILE |
    LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
    LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_BLOCK |
    LANDLOCK_ACCESS_FS_MAKE_SYM;
// Moving files between folders; version 1 always forbids it.
constexpr std::uint64_t kRefer = 1ULL << 13;
// Since version 3, which is newer than the header of Debian 12.
constexpr std::uint64_t kTruncate = 1ULL << 14;

// landlock_ruleset_attr of version 6, which is newer than the header, too.
struct RulesetAttributes {
  std::uint64_t files = 0;
  std::uint64_t network = 0;
  std::uint64_t scoped = 0;
};
constexpr int kFirstScopedVersion = 6;
// No abstract sockets of others, no signals to others.
constexpr std::uint64_t kScoped = (1ULL << 0) | (1ULL << 1);

std::uint64_t writing(int version) {
  return kWritingFirst | (version >= 2 ? kRefer : 0) | (version >= 3 ? kTruncate : 0);
}

// The rights in a rule about something other than a folder.
constexpr std::uint64_t kOfFiles = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE |
                                   LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate;

bool allow(int ruleset, const std::filesystem::path& path, std::uint64_t access) {
  const base::UniqueFd place(::open(path.c_str(), O_PATH | O_CLOEXEC));
  if (!place) return true;

  struct stat status = {};
  if (::fstat(place.get(), &status) != 0) return false;
  landlock_path_beneath_attr rule{};
  rule.allowed_access = S_ISDIR(status.st_mode) ? access : access & kOfFiles;
  rule.parent_fd = place.get();
  return ::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) == 0;
}

}  // namespace

int landlock_version() {
  const long version =
      ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  return version > 0 ? static_cast<int>(version) : 0;
}

base::UniqueFd make_ruleset(const FileAccess& files) {
  const int version = landlock_version();
  const bool scoped = version >= kFirstScopedVersion;
  const std::uint64_t everything = kReading | writing(version);
  const RulesetAttributes handled{everything, 0, scoped ? kScoped : 0};

  base::UniqueFd ruleset(static_cast<int>(::syscall(
      SYS_landlock_create_ruleset, &handled, scoped ? sizeof handled : sizeof handled.files, 0)));
  if (!ruleset) return ruleset;

  for (const auto& path : files.readable) {
    if (!allow(ruleset.get(), path, kReading)) return {};
  }
  for (const auto* paths : {&files.writable, &files.own}) {
    for (const auto& path : *paths) {
      if (!allow(ruleset.get(), path, everything)) return {};
    }
  }
  return ruleset;
}

bool enforce_ruleset(int ruleset) {
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         ::syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
}

}  // namespace cls::process
