// One line format per shape.
#include "proxy/actions/debug_lines.h"

#include <fmt/format.h>

#include <initializer_list>
#include <iterator>

#include "base/overloaded.h"
#include "proxy/actions/log_member.h"

namespace cls::proxy {
namespace {

/// `CYCLE,STOPPED LEVEL KIND NUMBER ... TEXT`, the text without its line breaks.
void append_line(player::GameTime now, int level, char kind, std::initializer_list<double> numbers,
                 std::string_view text, std::string& out) {
  fmt::format_to(std::back_inserter(out), "{},{} {} {}", now.cycle, now.stopped, level, kind);
  for (const double number : numbers) fmt::format_to(std::back_inserter(out), " {:.4f}", number);
  if (!text.empty()) out += ' ';
  for (const char c : text) out += c == '\n' || c == '\r' ? ' ' : c;
  out += '\n';
}

}  // namespace

bool is_logged(const protos::Log& log, std::uint32_t levels) {
  std::uint32_t level = 0;
  visit_member(log, [&](const auto& m) { level = static_cast<std::uint32_t>(m.level()); });
  return level == 0 || (level & levels) != 0;
}

bool append_debug_action(const protos::Log& log, player::GameTime now, std::string& out) {
  const auto line = [&](const auto& m, char kind, std::initializer_list<double> numbers,
                        std::string_view text) {
    append_line(now, m.level(), kind, numbers, text, out);
  };
  // Filled shapes use the capital letter.
  const auto shape = [&](const auto& m, char plain, std::initializer_list<double> numbers) {
    line(m, m.fill() ? static_cast<char>(plain - 'a' + 'A') : plain, numbers, m.color());
  };

  return visit_member(
      log, base::Overloaded{
               [&](const protos::AddText& m) { line(m, 'M', {}, m.message()); },
               [&](const protos::AddPoint& m) {
                 line(m, 'p', {m.point().x(), m.point().y()}, m.color());
               },
               [&](const protos::AddLine& m) {
                 line(m, 'l', {m.start().x(), m.start().y(), m.end().x(), m.end().y()}, m.color());
               },
               [&](const protos::AddArc& m) {
                 line(m, 'a',
                      {m.center().x(), m.center().y(), m.radius(), m.start_angle(), m.span_angel()},
                      m.color());
               },
               [&](const protos::AddCircle& m) {
                 shape(m, 'c', {m.center().x(), m.center().y(), m.radius()});
               },
               [&](const protos::AddTriangle& m) {
                 shape(m, 't',
                       {m.point1().x(), m.point1().y(), m.point2().x(), m.point2().y(),
                        m.point3().x(), m.point3().y()});
               },
               [&](const protos::AddRectangle& m) {
                 shape(m, 'r', {m.left(), m.top(), m.length(), m.width()});
               },
               [&](const protos::AddSector& m) {
                 shape(m, 's',
                       {m.center().x(), m.center().y(), m.min_radius(), m.max_radius(),
                        m.start_angle(), m.span_angel()});
               },
               [&](const protos::AddMessage& m) {
                 const std::string color = m.color().empty() ? "" : "(c " + m.color() + ") ";
                 line(m, 'm', {m.position().x(), m.position().y()}, color + m.message());
               },
           });
}

void append_debug_text(std::string_view text, player::GameTime now, std::string& out) {
  append_line(now, 0, 'M', {}, text, out);
}

}  // namespace cls::proxy
