// JUnit XML, the form of results that CI systems read. fixtures/junit/junit.xsd is its schema.
#pragma once

#include <string>
#include <vector>

namespace cls::base {

struct JunitCase {
  enum class Result {
    kPassed,
    kFailed,  ///< the answer is no
    kError,   ///< there is no answer: something else went wrong
    kSkipped,
  };

  std::string group;  ///< what CI systems list it under
  std::string name;
  std::string file;  ///< where it is written down; empty: nowhere
  double seconds = 0.0;
  Result result = Result::kPassed;
  std::string type;     ///< kind of failure or error
  std::string message;  ///< one line: why it failed or was skipped
  std::string text;     ///< all there is to say
};

/// A whole report: one suite of that name.
std::string junit(const std::string& suite, const std::vector<JunitCase>& cases);

}  // namespace cls::base
