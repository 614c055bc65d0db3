// What programs linked on Debian 12 take from glibc 2.32 to 2.36, for hosts whose glibc is 2.31
// (Ubuntu 20.04, Debian 11). Functions that only moved from libpthread and libdl to libc are not
// here: packaging/build.py links their old versions.
#include <dirent.h>
#include <fcntl.h>
#include <link.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <cstdlib>

using Initializer = void (*)(int, char**, char**);

extern "C" {

// glibc 2.34 and later call the constructors of a program; earlier ones leave that to a function
// that crt1.o passes, and that of Debian 12 passes none.
extern Initializer __init_array_start[] __attribute__((visibility("hidden")));
extern Initializer __init_array_end[] __attribute__((visibility("hidden")));
int cls_old_start(int (*main)(int, char**, char**), int argc, char** argv, Initializer init,
                  void (*fini)(), void (*rtld_fini)(), void* stack_end);
__asm__(".symver cls_old_start, __libc_start_main@GLIBC_2.2.5");

// Not for the libraries that the program loads: they have those of their own C library.
#pragma GCC visibility push(hidden)

static void call_constructors(int argc, char** argv, char** variables) {
  for (Initializer* one = __init_array_start; one != __init_array_end; ++one) {
    (*one)(argc, argv, variables);
  }
}

int __wrap___libc_start_main(int (*main)(int, char**, char**), int argc, char** argv,
                             Initializer /*init*/, void (*fini)(), void (*rtld_fini)(),
                             void* stack_end) {
  return cls_old_start(main, argc, argv, call_constructors, fini, rtld_fini, stack_end);
}

// libstdc++ counts references without atomic operations while this is set.
char __libc_single_threaded = 0;

// The structure of the kernel for x86-64 is that of glibc.
int fstatat(int folder, const char* path, struct stat* status, int flags) noexcept {
  return static_cast<int>(syscall(SYS_newfstatat, folder, path, status, flags));
}
int stat(const char* path, struct stat* status) noexcept {
  return fstatat(AT_FDCWD, path, status, 0);
}
int lstat(const char* path, struct stat* status) noexcept {
  return fstatat(AT_FDCWD, path, status, AT_SYMLINK_NOFOLLOW);
}
int fstat(int file, struct stat* status) noexcept {
  return static_cast<int>(syscall(SYS_fstat, file, status));
}
static_assert(sizeof(struct stat) == sizeof(struct stat64));
int stat64(const char* path, struct stat64* status) noexcept {
  return stat(path, reinterpret_cast<struct stat*>(status));
}
int lstat64(const char* path, struct stat64* status) noexcept {
  return lstat(path, reinterpret_cast<struct stat*>(status));
}
int fstat64(int file, struct stat64* status) noexcept {
  return fstat(file, reinterpret_cast<struct stat*>(status));
}
int fstatat64(int folder, const char* path, struct stat64* status, int flags) noexcept {
  return fstatat(folder, path, reinterpret_cast<struct stat*>(status), flags);
}

int close_range(unsigned first, unsigned last, int flags) noexcept {
  return static_cast<int>(syscall(SYS_close_range, first, last, flags));
}

// Kernels before 5.9 have no close_range.
void closefrom(int first) noexcept {
  if (close_range(static_cast<unsigned>(first), ~0U, 0) == 0) return;
  DIR* folder = opendir("/proc/self/fd");
  if (folder == nullptr) {
    for (long file = sysconf(_SC_OPEN_MAX); file >= first; --file) close(static_cast<int>(file));
    return;
  }
  while (const dirent* entry = readdir(folder)) {
    const int file = std::atoi(entry->d_name);
    if (file >= first && file != dirfd(folder) && entry->d_name[0] != '.') close(file);
  }
  closedir(folder);
}

std::uint32_t arc4random() noexcept {
  std::uint32_t number = 0;
  if (getrandom(&number, sizeof number, 0) != sizeof number) std::abort();
  return number;
}

const char* sigabbrev_np(int signal) noexcept {
  static constexpr std::array<const char*, 32> kNames = {
      nullptr, "HUP",  "INT",  "QUIT", "ILL",    "TRAP",   "ABRT",  "BUS",  "FPE",  "KILL", "USR1",
      "SEGV",  "USR2", "PIPE", "ALRM", "TERM",   "STKFLT", "CHLD",  "CONT", "STOP", "TSTP", "TTIN",
      "TTOU",  "URG",  "XCPU", "XFSZ", "VTALRM", "PROF",   "WINCH", "POLL", "PWR",  "SYS"};
  return signal > 0 && signal < static_cast<int>(kNames.size())
             ? kNames[static_cast<std::size_t>(signal)]
             : nullptr;
}

// The loaded file that holds an address, for exceptions.
static int find_object(dl_phdr_info* info, std::size_t /*size*/, void* result) {
  auto* const found = static_cast<dl_find_object*>(result);
  const auto address = reinterpret_cast<std::uintptr_t>(found->dlfo_eh_frame);
  const ElfW(Phdr)* frames = nullptr;
  std::uintptr_t begin = UINTPTR_MAX;
  std::uintptr_t end = 0;
  bool holds = false;
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = info->dlpi_phdr[i];
    if (segment.p_type == PT_GNU_EH_FRAME) frames = &segment;
    if (segment.p_type != PT_LOAD) continue;
    const std::uintptr_t first = info->dlpi_addr + segment.p_vaddr;
    begin = first < begin ? first : begin;
    end = first + segment.p_memsz > end ? first + segment.p_memsz : end;
    holds = holds || (address >= first && address - first < segment.p_memsz);
  }
  if (!holds || frames == nullptr) return 0;
  found->dlfo_map_start = reinterpret_cast<void*>(begin);
  found->dlfo_map_end = reinterpret_cast<void*>(end);
  found->dlfo_eh_frame = reinterpret_cast<void*>(info->dlpi_addr + frames->p_vaddr);
  return 1;
}

int _dl_find_object(void* address, dl_find_object* result) noexcept {
  *result = {};
  result->dlfo_eh_frame = address;
  return dl_iterate_phdr(find_object, result) == 1 ? 0 : -1;
}

#pragma GCC visibility pop

}  // extern "C"
