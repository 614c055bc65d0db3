// The functions of SLEEF that soccer/ calls, for programs without libsleef.so.3 on their host: the
// library, compressed, is part of the program, which gives it to the dynamic linker at its start.
// Therefore a static program computes the same bits as one that links Debian's library.
//
// packaging/build.py defines CLS_SLEEF_FILE, the library compressed by zlib, CLS_SLEEF_SIZE, and
// CLS_SLEEF_FUNCTIONS, CLS_SLEEF_FUNCTION(name) for each function that programs call. A program
// ends if its library cannot be loaded. In a library (CLS_SLEEF_IN_LIBRARY) the process goes on:
// cls_math_library_fault() says why, and the functions compute nothing.
#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

#include <array>
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

std::array<char, 256> fault = {};  // no object with a constructor: that would run later

// Keeps the first cause.
void fail(const char* what) {
  if (fault[0] != '\0') return;
  std::snprintf(fault.data(), fault.size(), "the embedded libsleef cannot be loaded: %s", what);
#ifndef CLS_SLEEF_IN_LIBRARY
  std::fprintf(stderr, "cls: %s\n", fault.data());
  std::_Exit(70);
#endif
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

// Empty if it is corrupt.
std::string uncompressed() {
  std::string bytes(CLS_SLEEF_SIZE, '\0');
  uLongf size = CLS_SLEEF_SIZE;
  const int done = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                              reinterpret_cast<const Bytef*>(cls_sleef_begin),
                              static_cast<uLong>(cls_sleef_end - cls_sleef_begin));
  if (done != Z_OK || size != CLS_SLEEF_SIZE) bytes.clear();
  return bytes;
}

// A file in memory is found in /proc only; without /proc, as in a bare chroot, a temporary file
// does. nullptr after fail().
void* load() {
  const std::string bytes = uncompressed();
  if (bytes.empty()) {
    fail("it is corrupt");
    return nullptr;
  }

  void* library = nullptr;
  if (const int file = memfd_create("libsleef.so.3", MFD_CLOEXEC); file >= 0) {
    library = load_from(file, "/proc/self/fd/" + std::to_string(file), bytes);
    close(file);
  }
  if (library != nullptr) return library;

  const char* folder = std::getenv("TMPDIR");
  std::string path = std::string(folder == nullptr ? "/tmp" : folder) + "/cls-sleef-XXXXXX";
  const int file = mkostemp(path.data(), 0);
  if (file < 0) {
    fail(path.c_str());
    return nullptr;
  }
  library = load_from(file, path, bytes);
  close(file);
  unlink(path.c_str());
  if (library == nullptr) fail(dlerror());
  return library;
}

extern "C" void cls_sleef_nothing() __attribute__((visibility("hidden")));

void* find(const char* name) {
  static void* const library = load();
  void* const address = library == nullptr ? nullptr : dlsym(library, name);
  if (address != nullptr) return address;
  fail(name);
  return reinterpret_cast<void*>(&cls_sleef_nothing);
}

}  // namespace

// Zeros, whatever the types: vectors in registers, larger results where the caller says.
__asm__(
    ".text\n.globl cls_sleef_nothing\n.hidden cls_sleef_nothing\n"
    ".type cls_sleef_nothing, @function\ncls_sleef_nothing:\n"
    "  mov %rdi, %rax\n  xorps %xmm0, %xmm0\n  xorps %xmm1, %xmm1\n  ret\n.previous\n");

// nullptr if the library is loaded.
extern "C" __attribute__((visibility("hidden"))) const char* cls_math_library_fault() {
  return fault[0] == '\0' ? nullptr : fault.data();
}

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
