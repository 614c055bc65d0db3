// Names folder contents and renames what must be kept.
#include "base/io/occupied_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace cls::base {

namespace fs = std::filesystem;

std::string contents_of(const fs::path& folder) {
  constexpr std::size_t kNamed = 2;
  std::vector<std::string> names;
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    names.push_back(entry->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  if (names.size() <= kNamed) return fmt::format("{}", fmt::join(names, " and "));
  const std::size_t more = names.size() - kNamed;
  names.resize(kNamed);
  return fmt::format("{} and {} more", fmt::join(names, ", "), more);
}

Result<fs::path> set_aside(const fs::path& path) {
  fs::path present = fs::absolute(path).lexically_normal();
  if (!present.has_filename()) present = present.parent_path();  // a trailing slash
  std::error_code code;
  fs::path renamed = present.string() + ".old";
  for (int i = 2; fs::exists(renamed, code); ++i) {
    renamed = fmt::format("{}.old{}", present.string(), i);
  }
  fs::rename(present, renamed, code);
  if (code) {
    return Error{fmt::format("cannot rename {} to {}: {}", present.string(), renamed.string(),
                             code.message())};
  }
  return renamed;
}

}  // namespace cls::base
