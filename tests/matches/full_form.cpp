// Asking the environment.
#include "tests/matches/full_form.h"

#include <cstdlib>

namespace cls::tests {

bool full_form() { return std::getenv("CLS_FULL") != nullptr; }

}  // namespace cls::tests
