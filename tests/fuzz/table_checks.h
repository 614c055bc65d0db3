// Invariants for any bytes read as a table; shared by a fuzzer and a test of its corpus.
#pragma once

#include <string_view>

namespace cls::tests {

/// Reads the bytes as a tracking table, a prediction and each file of a test of the trajectory
/// challenge, and predicts from their last row. Aborts on a violation.
void check_table(std::string_view bytes);

}  // namespace cls::tests
