// Validates XML with xmllint.
#include "tests/support/junit.h"

#include <fstream>

#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {

std::optional<std::string> junit_errors(const std::string& xml) {
  if (run({"/bin/sh", "-c", "command -v xmllint"}).exit_code != 0) return std::nullopt;
  const TemporaryFolder folder;
  const std::string file = folder.path() / "junit.xml";
  std::ofstream(file) << xml;
  const CommandResult result =
      run({"xmllint", "--noout", "--schema", fixture("junit/junit.xsd"), file});
  return result.exit_code == 0 ? "" : result.err;
}

}  // namespace cls::tests
