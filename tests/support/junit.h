// Validates JUnit reports against their schema.
#pragma once

#include <optional>
#include <string>

namespace cls::tests {

/// Errors of xmllint with fixtures/junit/junit.xsd; empty: valid. Nothing without xmllint; then
/// `GTEST_SKIP() << "no xmllint (package libxml2-utils)"`.
std::optional<std::string> junit_errors(const std::string& xml);

}  // namespace cls::tests
