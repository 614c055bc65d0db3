// Reads program headers and the dynamic section (System V ABI, ELF; symbol versions:
// LSB 5.0, 10.7).
#include "cli/project/elf_file.h"

#include <elf.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <string_view>

#include "base/io/whole_file.h"
#include "base/text/number_text.h"

namespace cls::cli {
namespace {

constexpr std::size_t kMaxEntries = 100'000;  // a corrupt file must not loop

// Reads at offsets, all of which may be wrong.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  std::optional<T> at(std::uint64_t offset) const {
    T value;
    if (offset > bytes_.size() || bytes_.size() - offset < sizeof value) return std::nullopt;
    std::memcpy(&value, bytes_.data() + offset, sizeof value);
    return value;
  }

  std::string text(std::uint64_t offset) const {
    if (offset >= bytes_.size()) return {};
    const std::string_view rest = bytes_.substr(offset);
    return std::string(rest.substr(0, rest.find('\0')));
  }

 private:
  std::string_view bytes_;
};

// Where the bytes of an address are in the file.
std::uint64_t offset_of(std::uint64_t address, const std::vector<Elf64_Phdr>& segments) {
  for (const Elf64_Phdr& one : segments) {
    if (one.p_type == PT_LOAD && address >= one.p_vaddr && address - one.p_vaddr < one.p_filesz) {
      return address - one.p_vaddr + one.p_offset;
    }
  }
  return UINT64_MAX;
}

void read_versions(const Bytes& bytes, std::uint64_t offset, std::uint64_t count,
                   std::uint64_t names, std::vector<std::string>& versions) {
  for (std::uint64_t i = 0; i < std::min<std::uint64_t>(count, kMaxEntries); ++i) {
    const auto need = bytes.at<Elf64_Verneed>(offset);
    if (!need) return;
    std::uint64_t entry = offset + need->vn_aux;
    for (int k = 0; k < need->vn_cnt; ++k) {
      const auto version = bytes.at<Elf64_Vernaux>(entry);
      if (!version) return;
      versions.push_back(bytes.text(names + version->vna_name));
      entry += version->vna_next;
    }
    offset += need->vn_next;
  }
}

// "2.34" of "GLIBC_2.34" as comparable numbers.
std::vector<int> version_numbers(std::string_view text) {
  std::vector<int> numbers;
  while (!text.empty()) {
    int value = 0;
    const std::size_t length = base::parse_int_prefix(text, value);
    if (length == 0) return {};
    numbers.push_back(value);
    text.remove_prefix(length);
    if (!text.empty()) text.remove_prefix(1);
  }
  return numbers;
}

bool is_at_most(std::string_view version, std::string_view limit) {
  const std::vector<int> numbers = version_numbers(version);
  return !numbers.empty() && numbers <= version_numbers(limit);
}

}  // namespace

std::optional<ElfFile> read_elf_file(const std::filesystem::path& path) {
  const auto content = base::read_file(path);
  if (!content || !content->starts_with(ELFMAG)) return std::nullopt;

  const Bytes bytes(*content);
  const auto header = bytes.at<Elf64_Ehdr>(0);
  if (!header || header->e_ident[EI_CLASS] != ELFCLASS64 || header->e_machine != EM_X86_64) {
    return std::nullopt;
  }

  ElfFile file;
  std::vector<Elf64_Phdr> segments;
  std::map<std::int64_t, std::uint64_t> values;  // of the dynamic section
  std::vector<std::uint64_t> needed;
  for (int i = 0; i < header->e_phnum; ++i) {
    const auto segment = bytes.at<Elf64_Phdr>(header->e_phoff + i * sizeof(Elf64_Phdr));
    if (!segment) return std::nullopt;
    segments.push_back(*segment);
  }

  for (const Elf64_Phdr& segment : segments) {
    if (segment.p_type == PT_INTERP) file.loader = bytes.text(segment.p_offset);
    if (segment.p_type != PT_DYNAMIC) continue;
    for (std::size_t i = 0; i < kMaxEntries; ++i) {
      const auto entry = bytes.at<Elf64_Dyn>(segment.p_offset + i * sizeof(Elf64_Dyn));
      if (!entry || entry->d_tag == DT_NULL) break;
      if (entry->d_tag == DT_NEEDED) needed.push_back(entry->d_un.d_val);
      values[entry->d_tag] = entry->d_un.d_val;
    }
  }

  const std::uint64_t names = offset_of(values[DT_STRTAB], segments);
  for (const std::uint64_t name : needed) file.needed.push_back(bytes.text(names + name));
  read_versions(bytes, offset_of(values[DT_VERNEED], segments), values[DT_VERNEEDNUM], names,
                file.versions);
  return file;
}

bool loads_on_oldest(const ElfFile& file) {
  static constexpr std::array<std::string_view, 10> kLibraries = {
      "libc.so.6",    "libm.so.6",      "libpthread.so.0",      "libdl.so.2",    "librt.so.1",
      "libutil.so.1", "libresolv.so.2", "ld-linux-x86-64.so.2", "libgcc_s.so.1", "libstdc++.so.6"};

  // Of Ubuntu 20.04, whose GCC is 9, with the libraries of GCC 10.
  static const std::map<std::string_view, std::string_view> kLimits = {
      {"GLIBC", kOldestCLibrary}, {"GLIBCXX", "3.4.28"}, {"CXXABI", "1.3.12"}, {"GCC", "7.0"}};

  const auto is_there = [](const std::string& name) {
    return std::ranges::find(kLibraries, name) != kLibraries.end();
  };
  const auto is_old = [](const std::string& version) {
    const std::size_t separator = version.find('_');
    const auto limit = kLimits.find(std::string_view(version).substr(0, separator));
    return separator != std::string::npos && limit != kLimits.end() &&
           is_at_most(std::string_view(version).substr(separator + 1), limit->second);
  };
  return std::ranges::all_of(file.needed, is_there) && std::ranges::all_of(file.versions, is_old);
}

}  // namespace cls::cli
