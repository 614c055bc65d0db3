// Which form of the tests of whole matches is asked for.
#pragma once

namespace cls::tests {

/// True with CLS_FULL in the environment (`make full`): matches of 6000 cycles, and many of them.
/// Else the short form, for every day.
bool full_form();

}  // namespace cls::tests
