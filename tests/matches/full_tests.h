// Selects the short or the long form of tests of full matches.
#pragma once

#include <cstdlib>

namespace cls::tests {

/// True with CLS_FULL in the environment (`make full`): many matches of 6000 cycles; otherwise
/// short ones.
inline bool full_tests_requested() { return std::getenv("CLS_FULL") != nullptr; }

}  // namespace cls::tests
