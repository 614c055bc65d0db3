// JUnit XML elements and attributes.
#include "base/report/junit.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/enum_names.h"
#include "base/text/xml.h"

namespace cls::base {
namespace {

using Result = JunitCase::Result;

constexpr auto kElements = enum_names<Result>("system-out", "failure", "error", "skipped");

void add_case(std::string& out, const JunitCase& one) {
  const auto attribute = [&out](const char* name, const std::string& value) {
    if (!value.empty()) out += fmt::format(" {}=\"{}\"", name, escape_xml(value));
  };

  out += "    <testcase";
  attribute("classname", one.group);
  attribute("name", one.name);
  attribute("file", one.file);
  out += fmt::format(" time=\"{:.3f}\"", one.seconds);

  // Jenkins and GitLab look for attachments in the output.
  const std::string attachment =
      one.attachment.empty() ? "" : fmt::format("[[ATTACHMENT|{}]]\n", one.attachment);
  if (one.result == Result::kPassed && one.text.empty() && attachment.empty()) {
    out += "/>\n";
    return;
  }

  const std::string_view element = kElements.name(one.result);
  out += fmt::format(">\n      <{}", element);
  if (one.result == Result::kPassed) {
    out += fmt::format(">{}</{}>\n    </testcase>\n", escape_xml(one.text + attachment), element);
    return;
  }

  attribute("type", one.type);
  attribute("message", one.message);
  out += fmt::format(">{}</{}>\n", escape_xml(one.text), element);
  if (!attachment.empty()) {
    out += fmt::format("      <system-out>{}</system-out>\n", escape_xml(attachment));
  }
  out += "    </testcase>\n";
}

}  // namespace

std::string format_junit(const std::string& suite, const std::vector<JunitCase>& cases) {
  const auto count = [&cases](Result result) {
    return std::ranges::count(cases, result, &JunitCase::result);
  };

  double seconds = 0.0;
  for (const JunitCase& one : cases) seconds += one.seconds;
  const std::string totals = fmt::format(
      "name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", escape_xml(suite),
      cases.size(), count(Result::kFailed), count(Result::kError), seconds);

  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {0}>\n"
      "  <testsuite {0} skipped=\"{1}\">\n",
      totals, count(Result::kSkipped));
  for (const JunitCase& one : cases) add_case(text, one);
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace cls::base
