// Suggestions for mistyped names.
#pragma once

#include <string_view>
#include <vector>

namespace cls::base {

/// The name of `names` that is most likely meant by the mistyped `word`, for "did you mean"; empty
/// when none is near (edit distance above a third of the word).
std::string_view nearest_name(std::string_view word, const std::vector<std::string_view>& names);

}  // namespace cls::base
