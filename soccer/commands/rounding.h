// Numbers of commands as agents send them.
#pragma once

#include <cmath>

namespace cls::soccer {

/// Rounds to three decimals: more has no effect in the server, and logs stay readable. The text of
/// a rounded number below 1000 parses to the same bits.
inline double rounded_for_command(double value) { return std::rint(value * 1000.0) / 1000.0; }

}  // namespace cls::soccer
