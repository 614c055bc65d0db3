// A tree of bind mounts on a tmpfs, which pivot_root makes the root folder.
#include "process/private_root.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include "base/system/unique_fd.h"

namespace cls::process {
namespace {

namespace fs = std::filesystem;

// While the new root grows, the old one is at kOld. /tmp is there on every system.
constexpr const char* kBase = "/tmp";
constexpr const char* kOld = "/old";
constexpr const char* kNew = "/new";
constexpr unsigned long kPlain = MS_NOSUID | MS_NODEV;
// Of folders in memory, each; enough for lock files and shared memory, too little to exhaust a
// host.
constexpr const char* kMemoryFolder = "mode=1777,size=256m,nr_inodes=64k";

fs::path inside(const char* root, const fs::path& path) { return root + path.string(); }

bool make_folders(const fs::path& path) {
  std::error_code code;
  fs::create_directories(path, code);
  errno = code.value();
  return !code;
}

bool is_folder(const fs::path& path) {
  struct stat status = {};
  return ::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

bool is_there(const fs::path& path) { return ::access(path.c_str(), F_OK) == 0; }

// Something to mount at: exists already where a folder above was mounted.
bool make_place(const fs::path& place, bool folder) {
  if (is_there(place)) return true;
  if (folder) return make_folders(place);
  if (!make_folders(place.parent_path())) return false;
  return static_cast<bool>(base::UniqueFd(::open(place.c_str(), O_CREAT | O_CLOEXEC, 0600)));
}

bool forbid_changes(const fs::path& place, unsigned flags) {
  mount_attr attributes{};
  attributes.attr_set = MOUNT_ATTR_RDONLY;
  return ::syscall(SYS_mount_setattr, AT_FDCWD, place.c_str(), flags, &attributes,
                   sizeof attributes) == 0;
}

struct Shown {
  fs::path path;
  bool writable = false;
};

// Folders before what is in them.
std::vector<Shown> in_order(const FileAccess& files) {
  std::vector<Shown> all;
  for (const fs::path& path : files.readable) all.push_back({path, false});
  for (const fs::path& path : files.writable) all.push_back({path, true});
  std::ranges::stable_sort(all, {}, &Shown::path);
  return all;
}

bool is_below(const fs::path& path, const fs::path& folder) {
  return std::ranges::mismatch(folder, path).in1 == folder.end();
}

// Already there as part of a folder that was mounted: the same, or one that can be changed.
bool is_shown(const std::vector<Shown>& before, const Shown& one) {
  return std::ranges::any_of(before, [&](const Shown& other) {
    return is_below(one.path, other.path) && (other.writable || !one.writable);
  });
}

bool show(const Shown& one) {
  const fs::path source = inside(kOld, one.path);
  const fs::path place = inside(kNew, one.path);
  if (!is_there(source)) return true;
  if (!make_place(place, is_folder(source))) return false;
  if (::mount(source.c_str(), place.c_str(), nullptr, MS_BIND | MS_REC, nullptr) != 0) return false;
  return one.writable || forbid_changes(place, AT_RECURSIVE);
}

bool show_all(const FileAccess& files) {
  std::vector<Shown> shown;
  for (const Shown& one : in_order(files)) {
    if (one.path == "/proc" || is_shown(shown, one)) continue;
    if (!show(one)) return false;
    shown.push_back(one);
  }
  return true;
}

bool make_own_folder(const fs::path& path) {
  const fs::path place = inside(kNew, path);
  return make_folders(place) &&
         ::mount("tmpfs", place.c_str(), "tmpfs", kPlain, kMemoryFolder) == 0;
}

bool cover(const fs::path& path) {
  const fs::path place = inside(kNew, path);
  return !is_folder(place) ||
         ::mount("tmpfs", place.c_str(), "tmpfs", kPlain | MS_RDONLY, "mode=0755,size=4k") == 0;
}

// Where it can be: one in a folder that is shown is there already, and none is necessary.
void make_link(const FileLink& link) {
  const fs::path place = inside(kNew, link.path);
  std::error_code ignored;
  fs::create_directories(place.parent_path(), ignored);
  fs::create_symlink(link.target, place, ignored);
}

const std::vector<FileLink>& device_links() {
  static const std::vector<FileLink> links = {{"/dev/fd", "/proc/self/fd"},
                                              {"/dev/stdin", "/proc/self/fd/0"},
                                              {"/dev/stdout", "/proc/self/fd/1"},
                                              {"/dev/stderr", "/proc/self/fd/2"}};
  return links;
}

bool fill(const FileAccess& files) {
  const fs::path processes = inside(kNew, "/proc");
  if (!make_folders(processes) ||
      ::mount("proc", processes.c_str(), "proc", kPlain | MS_NOEXEC, nullptr) != 0) {
    return false;
  }

  if (!std::ranges::all_of(files.own, make_own_folder) || !show_all(files) ||
      !std::ranges::all_of(files.covered, cover)) {
    return false;
  }
  std::ranges::for_each(files.links, make_link);
  std::ranges::for_each(device_links(), make_link);
  return true;
}

// The folder becomes the root, and the old root is mounted at `old` in it.
bool change_root(const char* folder, const char* old) {
  return ::chdir(folder) == 0 && ::syscall(SYS_pivot_root, ".", old) == 0 && ::chdir("/") == 0;
}

}  // namespace

bool enter_private_root(const FileAccess& files) {
  const bool prepared = ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                        ::mount("tmpfs", kBase, "tmpfs", kPlain, "mode=0755,size=1m") == 0 &&
                        ::mkdir(inside(kBase, kOld).c_str(), 0700) == 0 &&
                        ::mkdir(inside(kBase, kNew).c_str(), 0755) == 0 &&
                        change_root(kBase, kOld + 1);
  if (!prepared) return false;

  const bool filled = ::mount("tmpfs", kNew, "tmpfs", kPlain, "mode=0755,size=1m") == 0 &&
                      fill(files) && ::umount2(kOld, MNT_DETACH) == 0;
  // The root of before is mounted over the new one, and gone with the next step.
  return filled && change_root(kNew, ".") && ::umount2(".", MNT_DETACH) == 0 && ::chdir("/") == 0 &&
         forbid_changes("/", 0);
}

}  // namespace cls::process
