// Creates and deletes the folder, and tells the guard.
#include "process/scratch_folder.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "process/guard.h"

namespace cls::process {
namespace {

namespace fs = std::filesystem;

// The folder that std::filesystem::temp_directory_path() takes; its error would not name it.
fs::path temporary_folder() {
  for (const char* variable : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"}) {
    const char* folder = std::getenv(variable);
    if (folder != nullptr && *folder != '\0') return folder;
  }
  return "/tmp";
}

}  // namespace

void remove_tree(const fs::path& folder) {
  std::error_code code;
  fs::remove_all(folder, code);
  if (!code) return;

  // Each folder is made writable before the walk enters it.
  fs::permissions(folder, fs::perms::owner_all, fs::perm_options::add, code);
  for (fs::recursive_directory_iterator at(folder, code), end; !code && at != end;
       at.increment(code)) {
    std::error_code ignored;
    if (!at->is_directory(ignored) || at->is_symlink(ignored)) continue;
    fs::permissions(at->path(), fs::perms::owner_all, fs::perm_options::add, ignored);
  }
  fs::remove_all(folder, code);
}

base::Result<ScratchFolder> ScratchFolder::create() {
  const fs::path parent = temporary_folder();
  std::string pattern = (parent / "cls-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    return base::Error{
        fmt::format("cannot create a temporary folder in '{}': {}; set TMPDIR to a "
                    "folder that you can write to",
                    parent.string(), std::strerror(errno))};
  }

  if (const Guard* guard = Guard::active()) guard->delete_at_exit(pattern);
  return ScratchFolder(pattern);
}

ScratchFolder::~ScratchFolder() {
  if (path_.empty()) return;
  remove_tree(path_);
  if (const Guard* guard = Guard::active()) guard->forget(path_);
}

}  // namespace cls::process
