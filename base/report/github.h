// Annotations of GitHub Actions: lines that its log viewer turns into marks at a file's line.
#pragma once

#include <string>
#include <string_view>

namespace cls::base {

/// Where an annotation stands; without a file it stands at the job.
struct AnnotationPlace {
  std::string file;
  int line = 1;
};

/// One error, as a line for the log; `message` may have several lines.
std::string github_error(const AnnotationPlace& place, std::string_view title,
                         std::string_view message);

}  // namespace cls::base
