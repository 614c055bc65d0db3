// Workflow commands of GitHub Actions.
#include "base/report/github.h"

#include <fmt/format.h>

namespace cls::base {
namespace {

// % and line ends must be escaped; in properties , and : too.
std::string escaped(std::string_view text, bool property) {
  std::string out;
  for (const char c : text) {
    const bool special = c == '%' || c == '\n' || c == '\r' || (property && (c == ',' || c == ':'));
    out += special ? fmt::format("%{:02X}", c) : std::string(1, c);
  }
  return out;
}

}  // namespace

std::string format_github_error(const AnnotationPlace& place, std::string_view title,
                                std::string_view message) {
  const std::string where =
      place.file.empty() ? ""
                         : fmt::format("file={},line={},", escaped(place.file, true), place.line);
  return fmt::format("::error {}title={}::{}\n", where, escaped(title, true),
                     escaped(message, false));
}

}  // namespace cls::base
