// Suggestions for mistyped names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cls::base {

/// The name that is most similar to the mistyped `word`; empty if the edit distance of all names is
/// above a third of the length of `word`.
std::string_view nearest_name(std::string_view word, const std::vector<std::string_view>& names);

/// "; did you mean 'x'?" for the nearest name or one that starts with `word`; empty if there is
/// none.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& names);

}  // namespace cls::base
