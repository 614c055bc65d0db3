// Invariants for any bytes read as a stream, page or decisions of the viewer; shared by the fuzzer
// and a test.
#pragma once

#include <string_view>

namespace cls::tests {

/// Reads the bytes as decisions, and as a page if they start like one, otherwise as chunks. What
/// was read is written and read again, and must be the same. Aborts on a violation.
void check_view(std::string_view bytes);

}  // namespace cls::tests
