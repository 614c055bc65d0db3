// Numbers of commands as agents send them.
#pragma once

#include <cmath>

namespace cls::soccer {

/// Rounds to three decimals: more has no effect in the server, and logs stay readable. The text of
/// a rounded number below 1000 parses to the same bits. Finite numbers stay finite.
inline double rounded_for_command(double value) {
  const double thousandths = value * 1000.0;
  return std::isfinite(thousandths) ? std::rint(thousandths) / 1000.0 : value;
}

}  // namespace cls::soccer
