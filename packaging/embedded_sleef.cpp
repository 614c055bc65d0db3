// The functions of SLEEF that soccer/ calls, for programs without libsleef.so.3 on their host: the
// library, compressed, is part of the program, which gives it to the dynamic linker at its start.
// Therefore a static program computes the same bits as one that links Debian's library.
//
// packaging/build.py defines CLS_SLEEF_FILE, the library compressed by zlib, CLS_SLEEF_SIZE, and
// CLS_SLEEF_FUNCTIONS, CLS_SLEEF_FUNCTION(name) for each function that programs call.
#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

// clang-format off
__asm__(
    ".section .rodata\n"
    ".local cls_sleef_begin\n"
    ".local cls_sleef_end\n"
    "cls_sleef_begin:\n"
    ".incbin \"" CLS_SLEEF_FILE "\"\n"
    "cls_sleef_end:\n"
    ".previous\n");
// clang-format on
extern "C" const char cls_sleef_begin[] __attribute__((visibility("hidden")));
extern "C" const char cls_sleef_end[] __attribute__((visibility("hidden")));

namespace {

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "cls: the embedded libsleef cannot be loaded: %s\n", what);
  std::_Exit(70);
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(file, bytes.data(), bytes.size());
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

// nullptr if it cannot be loaded from `file`.
void* load_from(int file, const std::string& path, std::string_view bytes) {
  return write_all(file, bytes) ? dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL) : nullptr;
}

std::string uncompressed() {
  std::string bytes(CLS_SLEEF_SIZE, '\0');
  uLongf size = CLS_SLEEF_SIZE;
  const int done = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                              reinterpret_cast<const Bytef*>(cls_sleef_begin),
                              static_cast<uLong>(cls_sleef_end - cls_sleef_begin));
  if (done != Z_OK || size != CLS_SLEEF_SIZE) fail("it is corrupt");
  return bytes;
}

// A file in memory is found in /proc only; without /proc, as in a bare chroot, a temporary file
// does.
void* load() {
  const std::string bytes = uncompressed();
  void* library = nullptr;
  if (const int file = memfd_create("libsleef.so.3", MFD_CLOEXEC); file >= 0) {
    library = load_from(file, "/proc/self/fd/" + std::to_string(file), bytes);
    close(file);
  }
  if (library != nullptr) return library;
  const char* folder = std::getenv("TMPDIR");
  std::string path = std::string(folder == nullptr ? "/tmp" : folder) + "/cls-sleef-XXXXXX";
  const int file = mkostemp(path.data(), 0);
  if (file < 0) fail(path.c_str());
  library = load_from(file, path, bytes);
  close(file);
  unlink(path.c_str());
  if (library == nullptr) fail(dlerror());
  return library;
}

void* find(const char* name) {
  static void* const library = load();
  void* const address = dlsym(library, name);
  if (address == nullptr) fail(name);
  return address;
}

}  // namespace

// A function is a jump to the address in its pointer. In assembly, because arguments and results
// differ: doubles, vectors, pairs of vectors.
#define CLS_SLEEF_FUNCTION(name)                                                           \
  extern "C" __attribute__((visibility("hidden"))) void* bound_##name;                     \
  void* bound_##name = nullptr;                                                            \
  __asm__(".text\n.globl " #name "\n.hidden " #name "\n.type " #name ", @function\n" #name \
          ": jmp *bound_" #name "(%rip)\n.previous\n");
CLS_SLEEF_FUNCTIONS
#undef CLS_SLEEF_FUNCTION

// Before the initialization of any other variable, which may call them.
#define CLS_SLEEF_FUNCTION(name) bound_##name = find(#name);
__attribute__((constructor(101))) static void bind_functions() { CLS_SLEEF_FUNCTIONS }
