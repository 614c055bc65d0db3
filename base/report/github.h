// Error annotations of GitHub Actions: log lines that its viewer shows at a line of a source file.
#pragma once

#include <string>
#include <string_view>

namespace cls::base {

/// Source line of an annotation; without a file it belongs to the job.
struct AnnotationPlace {
  std::string file;
  int line = 1;
};

/// One log line that reports an error; `message` may have several lines.
std::string format_github_error(const AnnotationPlace& place, std::string_view title,
                                std::string_view message);

}  // namespace cls::base
