// Looks at lines of teams and frames only.
#include "viewer/live/log_glance.h"

#include <array>
#include <cstdio>
#include <fstream>

namespace cls::viewer {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 20;

}  // namespace

void LogGlance::read_line(std::string_view line) {
  // Numbers are at the start; sscanf needs an end.
  const std::string start(line.substr(0, 400));
  Glance seen = glance_;
  if (std::sscanf(start.c_str(), "(team %*d %*s %*s %d %d", &seen.left, &seen.right) == 2) {
    glance_ = seen;
  } else if (std::sscanf(start.c_str(), "(show %d ((b) %lf %lf", &seen.cycle, &seen.ball.x,
                         &seen.ball.y) == 3) {
    glance_ = seen;
    any_ = true;
  }
}

std::optional<Glance> LogGlance::now() {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file_, code);
  if (code) return std::nullopt;
  if (size < read_) *this = LogGlance(file_);  // another match
  std::ifstream in(file_, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(read_));
  std::string rest;
  std::string block(kBlock, '\0');
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    rest.append(block, 0, static_cast<std::size_t>(in.gcount()));
    std::size_t start = 0;
    for (std::size_t end = rest.find('\n'); end != std::string::npos;
         end = rest.find('\n', start)) {
      read_line(std::string_view(rest).substr(start, end - start));
      start = end + 1;
    }
    rest.erase(0, start);
    read_ += start;
  }
  return any_ ? std::optional(glance_) : std::nullopt;
}

}  // namespace cls::viewer
