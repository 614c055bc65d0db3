// Verdicts as text, JSON, JUnit XML and annotations.
#include "scenario/suite_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text/json.h"
#include "tests/support/junit.h"

namespace cls::scenario {
namespace {

using testing::HasSubstr;
using testing::Not;

Scenario scenario(const std::string& name) {
  Scenario scenario;
  scenario.name = name;
  scenario.file = "tests/" + name + ".json";
  scenario.about = "About " + name + ".";
  return scenario;
}

struct Sample {
  Scenario good = scenario("good");
  Scenario bad = scenario("bad");
  Scenario skipped = scenario("skipped");
  SuiteVerdict suite;

  Sample() {
    ScenarioVerdict passed;
    passed.scenario = &good;
    passed.seeds = {1, 2};
    passed.checks = {{"{\"score\":[1,0]}", 4, true, 2, 2, "", {}}};
    ScenarioVerdict failed;
    failed.scenario = &bad;
    failed.verdict = Verdict::kFailed;
    failed.seeds = {7};
    failed.seconds = 0.25;

    failed.checks = {{"a <name> & \"more\"", 9, false, 0, 1, "the score is 1 : 0,\n50% off", 7}};
    failed.replay = "runs/test/bad-seed-7";
    failed.page = "runs/test/bad-seed-7/match.html";
    failed.rerun = "cls test tests/bad.json --seed 7";
    ScenarioVerdict not_played;
    not_played.scenario = &skipped;
    not_played.verdict = Verdict::kSkipped;
    not_played.reason = "no side under test";
    suite.scenarios = {passed, failed, not_played};
  }
};

TEST(SuiteReport, TextNamesFailureLocationAndRerunCommand) {
  const Sample sample;
  EXPECT_EQ(to_text(sample.suite.scenarios[0]), "ok    good  (2 seeds)\n");
  EXPECT_EQ(to_text(sample.suite.scenarios[1]),
            "FAIL  bad\n"
            "      About bad.\n"
            "      tests/bad.json: line 9, seed 7: a <name> & \"more\": the score is 1 : 0,\n50% "
            "off\n"
            "      logs: runs/test/bad-seed-7\n"
            "      watch: runs/test/bad-seed-7/match.html\n"
            "      rerun: cls test tests/bad.json --seed 7\n");
  EXPECT_EQ(to_text(sample.suite.scenarios[2]), "skip  skipped: no side under test\n");
  EXPECT_EQ(summary(sample.suite, 1.25), "1 passed, 1 failed, 1 skipped in 1.2 s\n");
}

TEST(SuiteReport, FoldsSentencesOnNarrowTerminals) {
  const Sample sample;
  EXPECT_EQ(to_text(sample.suite.scenarios[1], false, 30),
            "FAIL  bad\n"
            "      About bad.\n"
            "      tests/bad.json: line 9,\n"
            "      seed 7: a <name> &\n"
            "      \"more\": the score is 1 :\n"
            "      0,\n"
            "      50% off\n"
            "      logs: runs/test/bad-seed-7\n"
            "      watch: runs/test/bad-seed-7/match.html\n"
            "      rerun: cls test tests/bad.json --seed 7\n");
}

TEST(SuiteReport, ColorsVerdicts) {
  const Sample sample;
  EXPECT_EQ(to_text(sample.suite.scenarios[0], true),
            "\x1b[32mok\x1b[0m    good\x1b[2m  (2 seeds)\x1b[0m\n");
  EXPECT_EQ(to_text(sample.suite.scenarios[1], true).rfind("\x1b[1;31mFAIL  bad\x1b[0m\n", 0), 0U);
  EXPECT_EQ(summary(sample.suite, 1.25, true),
            "1 passed, \x1b[1;31m1 failed\x1b[0m, 1 skipped in 1.2 s\n");
}

TEST(SuiteReport, CountsInterruptedScenariosApart) {
  Sample sample;
  sample.suite.scenarios[1].verdict = Verdict::kInterrupted;
  EXPECT_EQ(summary(sample.suite, 1.25),
            "1 passed, 0 failed, 1 skipped in 1.2 s\n"
            "interrupted: 1 of 3 scenarios were not played to the end\n");
  const auto json = base::Json::parse(to_json(sample.suite));
  EXPECT_EQ(json["interrupted"], 1);
  EXPECT_EQ(json["scenarios"][1]["verdict"], "interrupted");
  EXPECT_EQ(to_annotations(sample.suite), "");
}

TEST(SuiteReport, NamesNoFileOfBuiltInScenario) {
  Sample sample;
  sample.bad.built_in = true;
  const std::string text = to_text(sample.suite.scenarios[1]);
  EXPECT_THAT(text, Not(HasSubstr("tests/bad.json: "))) << text;
  EXPECT_THAT(text, HasSubstr("      built-in scenario: line 9, seed 7: ")) << text;
  EXPECT_THAT(to_annotations(sample.suite), Not(HasSubstr("file=")));
}

TEST(SuiteReport, JsonContainsEveryCheck) {
  const Sample sample;
  const auto json = base::Json::parse(to_json(sample.suite));
  EXPECT_EQ(json["schema"], "cls.test/1");
  EXPECT_EQ(json["passed"], 1);
  EXPECT_EQ(json["failed"], 1);
  EXPECT_EQ(json["skipped"], 1);
  EXPECT_EQ(json["scenarios"][1]["checks"][0]["line"], 9);
  EXPECT_EQ(json["scenarios"][1]["checks"][0]["seed"], 7);
  EXPECT_EQ(json["scenarios"][1]["repeat"], "cls test tests/bad.json --seed 7");
  EXPECT_EQ(json["scenarios"][1]["page"], "runs/test/bad-seed-7/match.html");
}

TEST(SuiteReport, AnnotationsEscapeControlCharacters) {
  const Sample sample;
  EXPECT_EQ(
      to_annotations(sample.suite),
      "::error file=tests/bad.json,line=9,title=scenario bad::line 9, seed 7: a <name> & "
      "\"more\": the score is 1 : 0,%0A50%25 off%0Awatch: runs/test/bad-seed-7/match.html%0Arerun: "
      "cls test tests/bad.json --seed 7\n");
}

TEST(SuiteReport, MarkdownNamesThePageOfEachFailure) {
  Sample sample;
  EXPECT_EQ(to_markdown(sample.suite),
            "### cls test: 1 passed, 1 failed, 1 skipped\n\n"
            "| scenario | failure | replay page | rerun |\n"
            "|---|---|---|---|\n"
            "| bad | line 9, seed 7: a \\<name> & \"more\": the score is 1 : 0, | "
            "runs/test/bad-seed-7/match.html | cls test tests/bad.json --seed 7 |\n");
  sample.suite.scenarios.pop_back();
  sample.suite.scenarios.pop_back();
  EXPECT_EQ(to_markdown(sample.suite), "### cls test: 1 passed, 0 failed, 0 skipped\n");
}

TEST(SuiteReport, JUnitIsValid) {
  const Sample sample;
  const std::string xml = to_junit(sample.suite);
  EXPECT_THAT(xml, HasSubstr("a &lt;name&gt; &amp; &quot;more&quot;")) << xml;
  EXPECT_THAT(xml, HasSubstr("[[ATTACHMENT|runs/test/bad-seed-7/match.html]]")) << xml;
  const auto errors = tests::junit_errors(xml);
  if (!errors) GTEST_SKIP() << "no xmllint (package libxml2-utils)";
  EXPECT_EQ(*errors, "");
}

}  // namespace
}  // namespace cls::scenario
