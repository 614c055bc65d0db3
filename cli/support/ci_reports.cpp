// Options and output of CI reports.
#include "cli/support/ci_reports.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <string_view>

#include "base/io/whole_file.h"
#include "cli/support/print_error.h"

namespace cls::cli {
namespace {

bool runs_in_github_actions() {
  const char* actions = std::getenv("GITHUB_ACTIONS");
  return actions != nullptr && std::string_view(actions) == "true";
}

// All steps of a job append to one file.
void add_to_job_summary(const std::string& markdown) {
  const char* file = std::getenv("GITHUB_STEP_SUMMARY");
  if (file == nullptr || *file == '\0' || markdown.empty()) return;

  std::ofstream out(file, std::ios::app);
  out << markdown << '\n';
  out.flush();
  if (!out) print_error(0, "{}: cannot write the summary of the job", file);
}

}  // namespace

void add_ci_options(Command& command, CiReports& reports) {
  command.option("--junit FILE", reports.junit, "write a JUnit report to FILE")
      .of_group(kOutputGroup);
  command
      .flag("--github", reports.github,
            "print annotations on stderr (default in GitHub Actions: on)")
      .of_group(kOutputGroup);
}

ExitCode write_ci_reports(const CiReports& reports, const CiTexts& texts) {
  if (reports.github || runs_in_github_actions()) {
    fmt::print(stderr, "{}", texts.annotations);
    add_to_job_summary(texts.summary);
  }

  if (reports.junit.empty()) return kOk;
  const auto written = base::write_file(reports.junit, texts.junit);
  if (written) return kOk;
  print_error(0, written.error().message);
  return kCannotCreate;
}

}  // namespace cls::cli
