// Atomic writes by rename.
#include "base/io/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include "base/io/byte_sink.h"

namespace cls::base {
namespace {

Error cannot_create(const std::filesystem::path& path, const std::string& cause) {
  return Error{fmt::format("cannot create '{}': {}", path.string(), cause)};
}

// Puts the names in `folder` on the disk. File systems that cannot do that lose nothing else.
void sync_folder(const std::filesystem::path& folder) {
  const char* name = folder.empty() ? "." : folder.c_str();
  const int opened = ::open(name, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;
  ::fsync(opened);
  ::close(opened);
}

Result<void> write_by_rename(const std::filesystem::path& path, std::string_view bytes,
                             bool durable) {
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  auto file = FileSink::create(temporary.string());
  if (!file) return cannot_create(path, std::strerror(errno));
  (*file)->write(bytes);
  if (durable) (*file)->sync();
  std::error_code code;
  Result<void> written = (*file)->close();
  if (written) {
    std::filesystem::rename(temporary, path, code);
    if (code) written = cannot_create(path, code.message());
  }
  if (!written) {
    std::filesystem::remove(temporary, code);
    return written;
  }
  if (durable) sync_folder(path.parent_path());
  return {};
}

}  // namespace

std::optional<std::string> read_file(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

Result<void> write_file(const std::filesystem::path& path, std::string_view bytes) {
  return write_by_rename(path, bytes, false);
}

Result<void> write_file_durably(const std::filesystem::path& path, std::string_view bytes) {
  return write_by_rename(path, bytes, true);
}

std::optional<std::string> absence(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::exists(path, code)) return std::nullopt;
  return code ? code.message() : "no such file";
}

std::optional<std::string> why_no_file(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::is_regular_file(path, code)) return std::nullopt;
  if (std::filesystem::is_directory(path, code)) return "a folder, not a file";
  return absence(path).value_or("not a regular file");
}

std::optional<std::string> why_no_folder(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) return std::nullopt;
  return std::filesystem::exists(path, code) ? "a file, not a folder" : "no such folder";
}

Result<void> create_folders(const std::filesystem::path& folder) {
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (code) return cannot_create(folder, code.message());
  return {};
}

}  // namespace cls::base
