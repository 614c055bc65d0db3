// The file of this program, to start it again.
#pragma once

#include <filesystem>

#include "base/result.h"

namespace cls::base {

/// Its path, also after the file was replaced, by a new build for example; in a package of
/// `cls package-team` that of the script that starts it.
Result<std::filesystem::path> own_program();

}  // namespace cls::base
