// Reports of a suite: text, JSON, JUnit, Markdown, GitHub annotations.
#pragma once

#include <cstddef>
#include <string>

#include "scenario/suite.h"

namespace cls::scenario {

/// One scenario as text: verdict, failed checks and how to rerun them. With `color`, the verdict
/// has a terminal color. Sentences are folded at `width` characters, commands and paths are not; 0:
/// no line is folded.
std::string to_text(const ScenarioVerdict& verdict, bool color = false, std::size_t width = 0);

/// "34 passed, 1 failed, 0 skipped in 12.3 s", and a line on interrupted scenarios if there are
/// any.
std::string summary(const SuiteVerdict& suite, double seconds, bool color = false);

/// The document `cls.test/1`. Only "seconds" depends on the host.
std::string to_json(const SuiteVerdict& suite);

/// JUnit XML: one testsuite, one testcase per scenario.
std::string to_junit(const SuiteVerdict& suite);

/// GitHub annotations, one ::error line per failed check.
std::string to_annotations(const SuiteVerdict& suite);

/// A summary for people: counts, and a row for each failed scenario with the page that shows it.
std::string to_markdown(const SuiteVerdict& suite);

}  // namespace cls::scenario
