// JSON, one value per line.
#include "viewer/terminal/asciinema_cast.h"

#include <cmath>

#include "base/text/json.h"
#include "base/text/json_text.h"

namespace cls::viewer {

using base::Json;

std::string cast_header(int columns, int rows, const std::string& title) {
  const Json header = {{"version", 2},
                       {"width", columns},
                       {"height", rows},
                       {"title", title},
                       {"env", {{"TERM", "xterm-256color"}}}};
  return base::json_line(header) + "\n";
}

std::string cast_line(double seconds, std::string_view output) {
  const double rounded = std::round(seconds * 1000.0) / 1000.0;
  return base::json_line(Json::array({rounded, "o", output})) + "\n";
}

}  // namespace cls::viewer
