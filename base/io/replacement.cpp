// Temporary files in the folders of their targets.
#include "base/io/replacement.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
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

constexpr const char* kTemporary = ".partial-";

// Hidden, short enough for any file system, and not to be guessed.
std::string temporary_name(const fs::path& file) {
  constexpr std::size_t kMaxExtension = 16;
  std::uint64_t number = 0;
  // Never fails for so few bytes.
  [[maybe_unused]] const int drawn = ::getentropy(&number, sizeof(number));
  const std::string extension = file.extension().string();
  return fmt::format("{}{:016x}{}", kTemporary, number,
                     extension.size() <= kMaxExtension ? extension : "");
}

// A new file that is locked before it has its name. Without it errno says why; EEXIST: the name is
// taken.
UniqueFd create_locked(const fs::path& place) {
  const fs::path parent = place.parent_path();
  UniqueFd file(
      ::open(parent.empty() ? "." : parent.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666));
  if (file && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0) {
    const std::string unnamed = fmt::format("/proc/self/fd/{}", file.get());
    const int linked =
        ::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, place.c_str(), AT_SYMLINK_FOLLOW);
    if (linked == 0 || errno == EEXIST) return linked == 0 ? std::move(file) : UniqueFd();
  }

  // Some file systems have no files without a name.
  file = UniqueFd(::open(place.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file) ::flock(file.get(), LOCK_EX | LOCK_NB);
  return file;
}

bool is_locked(const fs::path& place) {
  const UniqueFd file(::open(place.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK));
  return !file || ::flock(file.get(), LOCK_SH | LOCK_NB) != 0;
}

}  // namespace

Replacement::Replacement(fs::path file, fs::path place, UniqueFd descriptor)
    : file_(std::move(file)),
      place_(std::move(place)),
      file_descriptor_(std::move(descriptor)),
      pending_(place_ != file_) {}

Replacement::Replacement(Replacement&& other) noexcept
    : file_(std::move(other.file_)),
      place_(std::move(other.place_)),
      file_descriptor_(std::move(other.file_descriptor_)),
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
    return Replacement(file, file, UniqueFd());
  }

  while (true) {
    fs::path place = file.parent_path() / temporary_name(file);
    if (UniqueFd created = create_locked(place)) {
      return Replacement(std::move(file), std::move(place), std::move(created));
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
  file_descriptor_.reset();
  return {};
}

void remove_abandoned(const fs::path& folder) {
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code)) {
    const std::string name = entry.path().filename().string();
    std::error_code ignored;
    if (!name.starts_with(kTemporary) || !entry.is_regular_file(ignored)) continue;
    if (!is_locked(entry.path())) fs::remove(entry.path(), ignored);
  }
}

}  // namespace cls::base
