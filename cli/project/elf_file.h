// Programs and libraries of Linux: what they need to be loaded.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cls::cli {

/// The dynamic section of a file for x86-64.
struct ElfFile {
  std::string loader;               ///< "/lib64/ld-linux-x86-64.so.2"; empty: static, or a library
  std::vector<std::string> needed;  ///< "libc.so.6"
  std::vector<std::string> versions;  ///< of symbols and formats: "GLIBC_2.34", "GLIBCXX_3.4.29"
};

/// Nothing if the file is not in the ELF format for x86-64, or is corrupt.
std::optional<ElfFile> read_elf_file(const std::filesystem::path& path);

/// The C library whose systems start a package: glibc 2.31, of Ubuntu 20.04.
inline constexpr const char* kOldestCLibrary = "2.31";

/// True if those systems load the file as it is: from the C library and that of GCC it needs
/// nothing newer, and from other libraries nothing.
bool loads_on_oldest(const ElfFile& file);

}  // namespace cls::cli
