// Steps of a check as JUnit XML and GitHub annotations.
#include "orchestration/checks/check_report.h"

#include <gtest/gtest.h>

#include "tests/support/junit.h"

namespace cls::orchestration::checks {
namespace {

CheckReport report() {
  CheckReport report;
  report.command = "cls check playmaker";
  report.subject = "localhost:50051";
  CheckStep reach{"reach", "Nothing goes without it.", StepResult::kSkip, "", 0.0};
  run_timed(reach, [] { return pass("Register replied"); });
  const CheckStep world{"no_world", "It may be refused, not crash.", StepResult::kFail,
                        "gRPC says <\xff\x01> & ends,\nat 50%", 0.5};
  const CheckStep bye{"bye", "It has to end.", StepResult::kSkip, "not reached", 0.0};
  report.steps = {reach, world, bye};
  return report;
}

TEST(CheckReport, JUnitContainsEachStep) {
  const std::string xml = to_junit(report());
  EXPECT_NE(xml.find("<testsuite name=\"cls check playmaker\" tests=\"3\" failures=\"1\" "
                     "errors=\"0\" time=\"0.500\" skipped=\"1\">"),
            std::string::npos)
      << xml;
  EXPECT_NE(xml.find("name=\"reach\""), std::string::npos);
  EXPECT_NE(xml.find("<system-out>Register replied</system-out>"), std::string::npos) << xml;
  EXPECT_NE(xml.find("why: It may be refused, not crash."), std::string::npos);
  EXPECT_NE(xml.find("<skipped message=\"not reached\">"), std::string::npos);
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
  EXPECT_NE(lines.find("ends,%0Aat 50%25%0Awhy: It may be refused"), std::string::npos) << lines;
}

}  // namespace
}  // namespace cls::orchestration::checks
