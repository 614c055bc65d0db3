// How the commands that read logs tell what is wrong with one.
#pragma once

#include <string_view>

#include "gamelog/damage.h"

namespace cls::cli {

/// A line for each of the first places on stderr, and one for how many more there are.
void report_damage(std::string_view path, const gamelog::DamageList& damage);

}  // namespace cls::cli
