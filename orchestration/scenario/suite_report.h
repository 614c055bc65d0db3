// What a suite came to, for people, programs and CI.
#pragma once

#include <string>

#include "orchestration/scenario/suite.h"

namespace cls::orchestration::scenario {

/// One scenario as lines of text: verdict, and of a failure what, where and how to repeat it.
std::string to_text(const ScenarioVerdict& verdict);

/// "34 passed, 1 failed, 0 skipped in 12.3 s".
std::string summary(const SuiteVerdict& suite, double seconds);

/// The document `cls.test/1`. Nothing in it but "seconds" depends on the machine.
std::string to_json(const SuiteVerdict& suite);

/// JUnit XML: one testsuite, one testcase a scenario.
std::string to_junit(const SuiteVerdict& suite);

/// GitHub annotations, one ::error line a failed check.
std::string to_annotations(const SuiteVerdict& suite);

}  // namespace cls::orchestration::scenario
