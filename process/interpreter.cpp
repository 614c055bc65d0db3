// Reads the first line of scripts and the program headers of ELF files.
#include "process/interpreter.h"

#include <elf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

#include "base/text/trimmed.h"

namespace cls::process {
namespace {

namespace fs = std::filesystem;

std::string read_at(std::ifstream& file, std::uint64_t offset, std::size_t size) {
  std::string bytes(size, '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

template <typename Struct>
bool read_struct(std::ifstream& file, std::uint64_t offset, Struct& into) {
  const std::string bytes = read_at(file, offset, sizeof into);
  if (bytes.size() != sizeof into) return false;
  std::memcpy(&into, bytes.data(), sizeof into);
  return true;
}

// The loader that a program header names; empty: a static program, or a corrupt one.
template <typename Header, typename ProgramHeader>
std::string loader_of(std::ifstream& file) {
  constexpr std::size_t kMaxName = 4096;
  Header header;
  if (!read_struct(file, 0, header)) return "";

  for (int i = 0; i < header.e_phnum; ++i) {
    ProgramHeader part;
    const std::uint64_t at = header.e_phoff + static_cast<std::uint64_t>(i) * sizeof part;
    if (!read_struct(file, at, part)) return "";
    if (part.p_type != PT_INTERP || part.p_filesz > kMaxName) continue;

    const std::string name = read_at(file, part.p_offset, part.p_filesz);
    return name.c_str();  // up to the terminating zero
  }
  return "";
}

std::string problem_of_script(std::string_view first_line) {
  const std::string_view line =
      base::trimmed(first_line.substr(0, first_line.find('\n')).substr(2), " \t");
  const std::string name(line.substr(0, line.find_first_of(" \t")));
  if (name.empty()) return "";

  std::error_code code;
  return fs::exists(name, code) ? "" : fmt::format("its interpreter {} does not exist", name);
}

}  // namespace

std::string missing_interpreter(const fs::path& program) {
  constexpr std::size_t kMaxFirstLine = 256;  // of the kernel
  std::ifstream file(program, std::ios::binary);
  const std::string start = read_at(file, 0, kMaxFirstLine);
  const bool text = start.find('\0') == std::string::npos;
  const std::size_t end = start.find('\n');
  if (text && end != std::string::npos && end > 0 && start[end - 1] == '\r') {
    return "its first line ends with a carriage return; write the file with line feeds only "
           "(sed -i 's/\\r$//')";
  }

  if (start.starts_with("#!")) return problem_of_script(start);
  if (!start.starts_with(ELFMAG) || start.size() <= EI_CLASS) return "";

  const std::string loader = start[EI_CLASS] == ELFCLASS32
                                 ? loader_of<Elf32_Ehdr, Elf32_Phdr>(file)
                                 : loader_of<Elf64_Ehdr, Elf64_Phdr>(file);
  std::error_code code;
  if (loader.empty() || fs::exists(loader, code)) return "";
  return fmt::format("its loader {} does not exist{}", loader,
                     start[EI_CLASS] == ELFCLASS32 ? " (a 32-bit program)" : "");
}

}  // namespace cls::process
