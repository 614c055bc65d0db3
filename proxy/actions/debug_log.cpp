// One line format per shape.
#include "proxy/actions/debug_log.h"

#include <fmt/format.h>

#include <iterator>

#include "proto/playmaker.pb.h"

namespace cls::proxy {
namespace {

/// Replaces line breaks.
std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return line;
}

class LineWriter {
 public:
  LineWriter(player::GameTime now, int level, std::string& out) : out_(out) {
    fmt::format_to(std::back_inserter(out_), "{},{} {}", now.cycle, now.stopped, level);
  }
  LineWriter& kind(char letter) {
    fmt::format_to(std::back_inserter(out_), " {}", letter);
    return *this;
  }
  LineWriter& number(double value) {
    fmt::format_to(std::back_inserter(out_), " {:.4f}", value);
    return *this;
  }
  LineWriter& point(const protos::RpcVector2D& p) { return number(p.x()).number(p.y()); }
  /// Text to the end of the line.
  void rest(std::string_view text) {
    if (!text.empty()) fmt::format_to(std::back_inserter(out_), " {}", one_line(text));
    out_ += '\n';
  }

 private:
  std::string& out_;
};

/// Filled shapes use the capital letter.
char letter(char plain, bool filled) {
  return filled ? static_cast<char>(plain - 'a' + 'A') : plain;
}

/// Shapes that can be filled.
bool append_shape(const protos::Log& log, player::GameTime now, std::string& out) {
  using Log = protos::Log;
  const auto line = [&](const auto& m) { return LineWriter(now, m.level(), out); };
  switch (log.log_case()) {
    case Log::kAddCircle: {
      const auto& m = log.add_circle();
      line(m).kind(letter('c', m.fill())).point(m.center()).number(m.radius()).rest(m.color());
      return true;
    }
    case Log::kAddTriangle: {
      const auto& m = log.add_triangle();
      line(m)
          .kind(letter('t', m.fill()))
          .point(m.point1())
          .point(m.point2())
          .point(m.point3())
          .rest(m.color());
      return true;
    }
    case Log::kAddRectangle: {
      const auto& m = log.add_rectangle();
      line(m)
          .kind(letter('r', m.fill()))
          .number(m.left())
          .number(m.top())
          .number(m.length())
          .number(m.width())
          .rest(m.color());
      return true;
    }
    case Log::kAddSector: {
      const auto& m = log.add_sector();
      line(m)
          .kind(letter('s', m.fill()))
          .point(m.center())
          .number(m.min_radius())
          .number(m.max_radius())
          .number(m.start_angle())
          .number(m.span_angel())
          .rest(m.color());
      return true;
    }
    default:
      return false;
  }
}

}  // namespace

int level_of(const protos::Log& log) {
  using Log = protos::Log;
  switch (log.log_case()) {
    case Log::kAddText:
      return log.add_text().level();
    case Log::kAddPoint:
      return log.add_point().level();
    case Log::kAddLine:
      return log.add_line().level();
    case Log::kAddArc:
      return log.add_arc().level();
    case Log::kAddCircle:
      return log.add_circle().level();
    case Log::kAddTriangle:
      return log.add_triangle().level();
    case Log::kAddRectangle:
      return log.add_rectangle().level();
    case Log::kAddSector:
      return log.add_sector().level();
    case Log::kAddMessage:
      return log.add_message().level();
    case Log::LOG_NOT_SET:
      break;
  }
  return 0;
}

bool append_debug_action(const protos::Log& log, player::GameTime now, std::string& out) {
  using Log = protos::Log;
  const auto line = [&](const auto& m) { return LineWriter(now, m.level(), out); };
  switch (log.log_case()) {
    case Log::kAddText: {
      const auto& m = log.add_text();
      line(m).kind('M').rest(m.message());
      return true;
    }
    case Log::kAddPoint: {
      const auto& m = log.add_point();
      line(m).kind('p').point(m.point()).rest(m.color());
      return true;
    }
    case Log::kAddLine: {
      const auto& m = log.add_line();
      line(m).kind('l').point(m.start()).point(m.end()).rest(m.color());
      return true;
    }
    case Log::kAddArc: {
      const auto& m = log.add_arc();
      line(m)
          .kind('a')
          .point(m.center())
          .number(m.radius())
          .number(m.start_angle())
          .number(m.span_angel())
          .rest(m.color());
      return true;
    }
    case Log::kAddMessage: {
      const auto& m = log.add_message();
      const std::string color = m.color().empty() ? "" : "(c " + m.color() + ") ";
      line(m).kind('m').point(m.position()).rest(color + m.message());
      return true;
    }
    default:
      return append_shape(log, now, out);
  }
}

void append_debug_text(std::string_view text, player::GameTime now, std::string& out) {
  LineWriter(now, 0, out).kind('M').rest(text);
}

}  // namespace cls::proxy
