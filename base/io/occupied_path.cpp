// Names folder contents and renames what must be kept.
#include "base/io/occupied_path.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

namespace cls::base {

namespace fs = std::filesystem;

namespace {

// Renames in one step, because another process may do the same. Sets errno when false.
bool rename_to_free_name(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno != EINVAL && errno != ENOSYS) return false;

  // The file system does not know that flag.
  std::error_code code;
  if (fs::exists(fs::symlink_status(to, code))) {
    errno = EEXIST;
    return false;
  }
  return ::rename(from.c_str(), to.c_str()) == 0;
}

}  // namespace

std::string contents_of(const fs::path& folder) {
  constexpr std::size_t kNamed = 2;
  std::vector<std::string> names;
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    names.push_back(entry->path().filename().string());
  }

  std::ranges::sort(names);
  if (names.size() <= kNamed) return fmt::format("{}", fmt::join(names, " and "));
  const std::size_t more = names.size() - kNamed;
  names.resize(kNamed);
  return fmt::format("{} and {} more", fmt::join(names, ", "), more);
}

Result<fs::path> set_aside(const fs::path& path) {
  fs::path present = fs::absolute(path).lexically_normal();
  if (!present.has_filename()) present = present.parent_path();  // a trailing slash

  std::error_code code;
  const fs::file_type type = fs::symlink_status(present, code).type();
  if (type != fs::file_type::regular && type != fs::file_type::directory &&
      type != fs::file_type::symlink && type != fs::file_type::not_found) {
    return Error{fmt::format("cannot rename {}: not a regular file", present.string())};
  }

  fs::path renamed = present.string() + ".old";
  for (int i = 2; !rename_to_free_name(present, renamed); ++i) {
    if (errno != EEXIST) {
      return Error{fmt::format("cannot rename {} to {}: {}", present.string(), renamed.string(),
                               std::strerror(errno))};
    }
    renamed = fmt::format("{}.old{}", present.string(), i);
  }
  return renamed;
}

}  // namespace cls::base
