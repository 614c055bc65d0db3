// Steps of a check as JUnit XML and GitHub annotations.
#include "checks/check_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/junit.h"

namespace cls::checks {
namespace {

using testing::HasSubstr;

CheckReport report() {
  CheckReport report;
  report.command = "cls check playmaker";
  report.subject = "localhost:50051";
  run_step(report, "reach", "Nothing goes without it.", [] { return pass("Register replied"); });
  const CheckStep world{"no_world", "It may be refused, not crash.", StepResult::kFail,
                        "gRPC says <\xff\x01> & ends,\nat 50%", 0.5};
  const CheckStep bye{"bye", "It has to end.", StepResult::kSkip, "not reached", 0.0};
  report.steps.insert(report.steps.end(), {world, bye});
  return report;
}

TEST(CheckReport, JUnitContainsEachStep) {
  const std::string xml = to_junit(report());
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"cls check playmaker\" tests=\"3\" failures=\"1\" "
                             "errors=\"0\" time=\"0.500\" skipped=\"1\">"))
      << xml;
  EXPECT_THAT(xml, HasSubstr("name=\"reach\""));
  EXPECT_THAT(xml, HasSubstr("<system-out>Register replied</system-out>")) << xml;
  EXPECT_THAT(xml, HasSubstr("why: It may be refused, not crash."));
  EXPECT_THAT(xml, HasSubstr("<skipped message=\"not reached\">"));
}

TEST(CheckReport, JUnitIsValidForArbitraryBytes) {
  const auto errors = tests::junit_errors(to_junit(report()));
  if (!errors) GTEST_SKIP() << "no xmllint (package libxml2-utils)";
  EXPECT_EQ(*errors, "");
}

TEST(CheckReport, AnnotationsContainFailedSteps) {
  const std::string lines = to_annotations(report());
  EXPECT_EQ(lines.rfind("::error title=cls check playmaker localhost%3A50051%3A no_world::gRPC "
                        "says <",
                        0),
            0u)
      << lines;
  EXPECT_THAT(lines, HasSubstr("ends,%0Aat 50%25%0Awhy: It may be refused")) << lines;
}

}  // namespace
}  // namespace cls::checks
