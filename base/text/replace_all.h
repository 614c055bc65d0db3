// Replaces words in a text.
#pragma once

#include <string>
#include <string_view>

namespace cls::base {

/// Replaces every `mark` in `text` with `value`, in which it does not search. `mark` is not empty.
void replace_all(std::string& text, std::string_view mark, std::string_view value);

}  // namespace cls::base
