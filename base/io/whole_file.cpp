// Atomic writes by rename.
#include "base/io/whole_file.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <system_error>

#include "base/io/byte_sink.h"

namespace cls::base {

std::optional<std::string> read_file(const std::filesystem::path& path) {
  std::error_code code;
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, code)) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

Result<void> write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  auto file = FileSink::create(temporary.string());
  if (!file) return file.error();
  (*file)->write(bytes);
  if (const auto closed = (*file)->close(); !closed) return closed;
  std::error_code code;
  std::filesystem::rename(temporary, path, code);
  if (code) {
    return Error{fmt::format("cannot create {}: {}", path.string(), code.message())};
  }
  return {};
}

}  // namespace cls::base
