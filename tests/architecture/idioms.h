// Idioms that the tree has a better form for, and declarations that nothing uses.
#pragma once

#include <vector>

#include "tests/architecture/rules.h"
#include "tests/architecture/source_text.h"

namespace cls::tests {

/// "TEXT: use REPLACEMENT" for each forbidden idiom in the code of a file.
std::vector<Violation> check_idioms(const SourceFile& file);

/// Functions, constants and types that a header of the product declares at the left margin and
/// that no other line of the tree names.
std::vector<Violation> check_unused_declarations(const std::vector<SourceFile>& files);

}  // namespace cls::tests
