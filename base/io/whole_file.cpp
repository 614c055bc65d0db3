// Writes through temporary files that are renamed.
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

#include "base/io/replacement.h"
#include "base/system/unique_fd.h"
#include "base/text/byte_order_mark.h"

namespace cls::base {
namespace {

Error cannot_create(const std::filesystem::path& path, const std::string& cause) {
  return Error{fmt::format("cannot create '{}': {}", path.string(), cause)};
}

Error cannot_write(const std::filesystem::path& path, int cause) {
  return Error{fmt::format("cannot write '{}': {}", path.string(), std::strerror(cause))};
}

// Puts the names in `folder` on the disk. File systems that cannot do that lose nothing else.
void sync_folder(const std::filesystem::path& folder) {
  const char* name = folder.empty() ? "." : folder.c_str();
  const int opened = ::open(name, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return;
  ::fsync(opened);
  ::close(opened);
}

// Pipes and devices have nothing to sync.
bool sync_file(int file) { return ::fsync(file) == 0 || errno == EINVAL; }

// Network file systems report errors when a descriptor is closed.
bool flush(int file) {
  const int copy = ::dup(file);
  return copy < 0 || ::close(copy) == 0;
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

Result<void> write_by_rename(const std::filesystem::path& path, std::string_view bytes,
                             bool durable) {
  TRY_INIT(auto replacement, Replacement::start(path));
  UniqueFd target;
  int file = replacement.descriptor();
  if (file < 0) {
    target = UniqueFd(
        ::open(replacement.place().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (!target) return cannot_create(path, std::strerror(errno));
    file = target.get();
  }

  const bool written = write_all(file, bytes) && (!durable || sync_file(file)) && flush(file);
  if (!written) return cannot_write(path, errno);

  TRY(replacement.finish());
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

std::optional<std::string> read_text(const std::filesystem::path& path) {
  auto text = read_file(path);
  if (text) remove_byte_order_mark(*text);
  return text;
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
  if (code) return code.message();
  return path.has_filename() ? "no such file" : "no such folder";
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
