// JUnit XML test reports for CI systems. Schema: fixtures/junit/junit.xsd.
#pragma once

#include <string>
#include <vector>

namespace cls::base {

struct JunitCase {
  enum class Result {
    kPassed,
    kFailed,  ///< an expectation was not met
    kError,   ///< the test could not be completed
    kSkipped,
  };

  std::string group;  ///< class name in CI systems
  std::string name;
  std::string file;  ///< source of the test; may be empty
  double seconds = 0.0;
  Result result = Result::kPassed;
  std::string type;             ///< kind of failure or error
  std::string message;          ///< one line: why it failed or was skipped
  std::string text;             ///< full output
  std::string attachment = {};  ///< path of a file about the case; empty: none
};

/// A report with one suite named `suite`.
std::string format_junit(const std::string& suite, const std::vector<JunitCase>& cases);

}  // namespace cls::base
