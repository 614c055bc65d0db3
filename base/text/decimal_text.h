// Numbers for readers.
#pragma once

#include <string>

namespace cls::base {

/// `value` with at most this many decimals: "1.5" for 1.50, "12" for 12.00, "0" for -0.00.
std::string decimal_text(double value, int decimals);

}  // namespace cls::base
