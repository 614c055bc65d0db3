// Holding JUnit reports against their schema.
#pragma once

#include <optional>
#include <string>

namespace cls::tests {

/// What xmllint says against it by fixtures/junit/junit.xsd; empty: it is valid. Nothing when there
/// is no xmllint; then `GTEST_SKIP() << "no xmllint (package libxml2-utils)"`.
std::optional<std::string> junit_mistakes(const std::string& xml);

}  // namespace cls::tests
