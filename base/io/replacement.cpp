// Temporary files beside their targets.
#include "base/io/replacement.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <utility>

namespace cls::base {
namespace {

namespace fs = std::filesystem;

Error cannot_create(const fs::path& file, const std::string& cause) {
  return Error{fmt::format("cannot create '{}': {}", file.string(), cause)};
}

// Hidden, short enough for any file system, and not to be guessed.
std::string temporary_name(const fs::path& file) {
  constexpr std::size_t kMaxExtension = 16;
  std::uint64_t number = 0;
  static_cast<void>(::getentropy(&number, sizeof(number)));  // never fails for so few bytes
  const std::string extension = file.extension().string();
  return fmt::format(".partial-{:016x}{}", number,
                     extension.size() <= kMaxExtension ? extension : "");
}

}  // namespace

Replacement::Replacement(fs::path file, fs::path place)
    : file_(std::move(file)), place_(std::move(place)), pending_(place_ != file_) {}

Replacement::Replacement(Replacement&& other) noexcept
    : file_(std::move(other.file_)),
      place_(std::move(other.place_)),
      pending_(std::exchange(other.pending_, false)) {}

Replacement::~Replacement() {
  std::error_code code;
  if (pending_) fs::remove(place_, code);
}

Result<Replacement> Replacement::start(fs::path file) {
  std::error_code code;
  const fs::file_type type = fs::symlink_status(file, code).type();
  if (type == fs::file_type::directory) return cannot_create(file, std::strerror(EISDIR));
  if (type != fs::file_type::regular && type != fs::file_type::not_found) {
    return Replacement(file, file);
  }

  while (true) {
    fs::path place = file.parent_path() / temporary_name(file);
    const int created = ::open(place.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (created >= 0) {
      ::close(created);
      return Replacement(std::move(file), std::move(place));
    }
    if (errno != EEXIST) return cannot_create(file, std::strerror(errno));
  }
}

Result<void> Replacement::finish() {
  if (!pending_) return {};
  std::error_code code;
  fs::rename(place_, file_, code);
  if (code) return cannot_create(file_, code.message());
  pending_ = false;
  return {};
}

}  // namespace cls::base
