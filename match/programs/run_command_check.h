// Looks for the programs and scripts that a `run:` command names.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cls::match {

/// The file that the first command of a `run:` side lacks, run in `folder`: "python3: no such
/// program on PATH", "playmaker.py: no such file". Follows `cd FOLDER &&`. Empty: nothing, or the
/// shell must expand the command first.
std::string missing_in_command(std::string_view command, std::filesystem::path folder);

}  // namespace cls::match
