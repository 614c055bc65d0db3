// How the commands that read logs tell what is wrong with one.
#pragma once

#include <string>
#include <string_view>

#include "gamelog/files/log_files.h"
#include "gamelog/record/damage.h"

namespace cls::cli {

/// A line for each of the first places on stderr, and one for how many more there are.
void report_damage(std::string_view path, const gamelog::DamageList& damage);

/// A line for each argument that stands for no log. Returns the exit code so far.
int report_missing(const gamelog::FoundLogs& found);

/// What became of one log of several: why it could not be opened (empty: it could), or its damage.
/// Returns what the exit code becomes of it.
int report_log(int exit_code, const std::string& unreadable, std::string_view path,
               const gamelog::DamageList& damage);

}  // namespace cls::cli
