// Creates and deletes the folder, and tells the guard.
#include "process/scratch_folder.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "process/guard.h"

namespace cls::process {
namespace {

namespace fs = std::filesystem;

base::Error cannot_create(const fs::path& parent, const std::error_code& cause) {
  return base::Error{fmt::format(
      "cannot create a temporary folder in '{}': {}; set TMPDIR to a folder that you can write to",
      parent.string(), cause.message())};
}

}  // namespace

base::Result<ScratchFolder> ScratchFolder::create() {
  fs::path parent;
  try {
    parent = fs::temp_directory_path();
  } catch (const fs::filesystem_error& error) {
    return cannot_create(error.path1(), error.code());
  }

  std::string pattern = (parent / "cls-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    return cannot_create(parent, {errno, std::generic_category()});
  }

  if (const Guard* guard = Guard::active()) guard->delete_at_exit(pattern);
  return ScratchFolder(pattern);
}

ScratchFolder::~ScratchFolder() {
  if (path_.empty()) return;
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (const Guard* guard = Guard::active()) guard->forget(path_);
}

}  // namespace cls::process
