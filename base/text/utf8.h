// UTF-8 validation.
#pragma once

#include <cstddef>
#include <string_view>

namespace cls::base {

/// Length of the well-formed UTF-8 sequence at the start of `text`, which must not be empty; 0 if
/// there is none.
std::size_t utf8_sequence_length(std::string_view text);

}  // namespace cls::base
