// The policy of `mock:learned`, as it lies in the program.
#pragma once

#include <string_view>

namespace cls::match {

/// The bytes of its file (docs/learned-team.md says how it was made).
std::string_view learned_policy();

}  // namespace cls::match
