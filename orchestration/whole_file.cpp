// Temporary file, then rename.
#include "orchestration/whole_file.h"

#include <fmt/format.h>

#include <system_error>

#include "gamelog/byte_sink.h"

namespace cls::orchestration {

soccer::Result<void> write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  auto file = gamelog::FileSink::create(temporary.string());
  if (!file) return file.error();
  (*file)->write(bytes);
  if (const auto closed = (*file)->close(); !closed) return closed;
  std::error_code code;
  std::filesystem::rename(temporary, path, code);
  if (code) {
    return soccer::Error{fmt::format("cannot create {}: {}", path.string(), code.message())};
  }
  return {};
}

}  // namespace cls::orchestration
