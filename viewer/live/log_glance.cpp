// Looks at lines of teams and frames only.
#include "viewer/live/log_glance.h"

#include <cstdio>
#include <fstream>

#include "base/index.h"
#include "base/io/byte_source.h"

namespace cls::viewer {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 20;

// "((l 1) TYPE FLAGS X Y ...": a player is on the pitch if the flags have bit 0.
void read_players(const std::string& frame, Glance& glance) {
  for (std::size_t at = frame.find(" (("); at != std::string::npos;
       at = frame.find(" ((", at + 1)) {
    char side = 0;
    int unum = 0;
    int type = 0;
    unsigned flags = 0;
    soccer::Vec2 place;
    const int count = std::sscanf(frame.c_str() + at, " ((%c %d) %d %x %lf %lf", &side, &unum,
                                  &type, &flags, &place.x, &place.y);
    if (count != 6 || (flags & 1U) == 0) continue;
    (side == 'l' ? glance.left_players : glance.right_players).push_back({unum, place});
  }
}

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
    frame_ = line;
    any_ = true;
  }
}

void LogGlance::read_lines(std::string& text) {
  std::string_view rest = text;
  for (std::size_t end = rest.find('\n'); end != rest.npos; end = rest.find('\n')) {
    read_line(rest.substr(0, end));
    rest.remove_prefix(end + 1);
  }
  text.erase(0, text.size() - rest.size());
}

// The end of a compressed log that grows is missing: what is there inflates.
void LogGlance::read_compressed() {
  const auto source = base::open_source(file_.string());
  if (!source) return;

  std::string rest;
  std::string block(kBlock, '\0');
  while (const std::size_t size = (*source)->read(block.data(), block.size())) {
    rest.append(block, 0, size);
    read_lines(rest);
  }
}

std::optional<Glance> LogGlance::last() const {
  if (!any_) return std::nullopt;
  Glance glance = glance_;
  read_players(frame_, glance);
  return glance;
}

std::optional<Glance> LogGlance::now() {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file_, code);
  if (code) return std::nullopt;

  const bool compressed = file_.extension() != ".rcg";
  if (size < read_ || (compressed && size != read_)) *this = LogGlance(file_);
  if (compressed) {
    if (size != read_) read_compressed();
    read_ = size;
    return last();
  }

  std::ifstream in(file_, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(read_));
  std::string rest;
  std::string block(kBlock, '\0');
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    const std::size_t count = base::index(in.gcount());
    read_ += count;
    rest.append(block, 0, count);
    read_lines(rest);
  }

  read_ -= rest.size();
  return last();
}

}  // namespace cls::viewer
