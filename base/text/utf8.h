// UTF-8 in the bytes of other programs.
#pragma once

#include <cstddef>
#include <string_view>

namespace cls::base {

/// Length of the well-formed UTF-8 sequence at the start of `text`, which is not empty; 0 when
/// there is none.
std::size_t utf8_length(std::string_view text);

}  // namespace cls::base
