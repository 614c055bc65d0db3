// Creates and deletes the folder, and tells the guard.
#include "process/scratch_folder.h"

#include <stdlib.h>

#include <string>
#include <system_error>

#include "process/guard.h"

namespace cls::process {

ScratchFolder::ScratchFolder() {
  std::error_code code;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(code);
  std::string pattern = (parent / "cls-XXXXXX").string();
  if (code || ::mkdtemp(pattern.data()) == nullptr) return;
  path_ = pattern;
  if (const Guard* guard = Guard::active()) guard->delete_at_exit(path_);
}

ScratchFolder::~ScratchFolder() {
  if (path_.empty()) return;
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  if (const Guard* guard = Guard::active()) guard->forget(path_);
}

}  // namespace cls::process
