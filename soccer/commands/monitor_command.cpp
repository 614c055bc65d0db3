// Parsing and formatting of monitor commands.
#include "soccer/commands/monitor_command.h"

#include <cmath>

#include "soccer/protocol/loose_scanner.h"
#include "soccer/protocol/text_writer.h"

namespace cls::soccer {
namespace {

constexpr double kScale = 16.0;
constexpr std::size_t kMaxTokenSize = 15;

using Read = std::optional<MonitorCommand>;

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }

bool read_place(LooseScanner& in, Vec2& place) {
  int x = 0;
  int y = 0;
  if (!in.integer(x) || !in.integer(y)) return false;
  place = {x / kScale, y / kScale};
  return true;
}

bool read_player(LooseScanner& in, Side& side, int& unum) {
  int sign = 0;
  if (!in.integer(sign) || !in.integer(unum)) return false;
  side = sign == 1 ? Side::kLeft : sign == -1 ? Side::kRight : Side::kNeutral;
  if (!is_unum(unum)) side = Side::kNeutral;
  return true;
}

Read read_foul(LooseScanner& in) {
  DispFoul foul;
  int sign = 0;
  if (!read_place(in, foul.position) || !in.integer(sign)) return std::nullopt;
  if (sign != 0) foul.side = sign > 0 ? Side::kLeft : Side::kRight;
  return foul;
}

Read read_placement(LooseScanner& in) {
  DispPlayer placed;
  int angle = 0;
  if (!read_player(in, placed.side, placed.unum) || !read_place(in, placed.position) ||
      !in.integer(angle)) {
    return std::nullopt;
  }
  placed.body = angle;
  return placed;
}

Read read_discard(LooseScanner& in) {
  DispDiscard discard;
  if (!read_player(in, discard.side, discard.unum)) return std::nullopt;
  return discard;
}

Read read_card(LooseScanner& in) {
  DispCard card;
  if (!read_player(in, card.side, card.unum)) return std::nullopt;

  const std::string_view color = in.run(is_lower, kMaxTokenSize);
  if (color != "yellow" && color != "red") return std::nullopt;
  card.red = color == "red";
  return card;
}

Read read_compression(LooseScanner& in) {
  Compression compression;
  if (!in.integer(compression.level)) return std::nullopt;
  return compression;
}

void append_place(Vec2 place, std::string& out) {
  append(out, ' ', static_cast<int>(std::rint(place.x * kScale)), ' ',
         static_cast<int>(std::rint(place.y * kScale)));
}

void append_player(Side side, int unum, std::string& out) {
  append(out, side == Side::kLeft ? " 1 " : " -1 ", unum);
}

struct Formatter {
  std::string& out;

  void operator()(const DispStart&) const { out += "(dispstart"; }
  void operator()(const DispBye&) const { out += "(dispbye"; }
  void operator()(const DispFoul& foul) const {
    out += "(dispfoul";
    append_place(foul.position, out);
    append(out, ' ', sign(foul.side));
  }
  void operator()(const DispPlayer& placed) const {
    out += "(dispplayer";
    append_player(placed.side, placed.unum, out);
    append_place(placed.position, out);
    append(out, ' ', static_cast<int>(std::rint(placed.body)));
  }
  void operator()(const DispDiscard& discard) const {
    out += "(dispdiscard";
    append_player(discard.side, discard.unum, out);
  }
  void operator()(const DispCard& card) const {
    out += "(dispcard";
    append_player(card.side, card.unum, out);
    out += card.red ? " red" : " yellow";
  }
  void operator()(const Compression& compression) const {
    append(out, "(compression ", compression.level);
  }
};

}  // namespace

std::optional<MonitorCommand> parse_monitor_command(std::string_view datagram) {
  if (!datagram.starts_with('(')) return std::nullopt;

  LooseScanner in(datagram.substr(1));
  if (LooseScanner::is_space(in.peek())) return std::nullopt;
  const std::string_view token = in.run(is_lower, kMaxTokenSize);

  if (datagram == "(dispstart)") return DispStart{};
  if (datagram == "(dispbye)") return DispBye{};
  if (token == "dispfoul") return read_foul(in);
  if (token == "dispplayer") return read_placement(in);
  if (token == "dispdiscard") return read_discard(in);
  if (token == "dispcard") return read_card(in);
  if (token == "compression") return read_compression(in);
  return std::nullopt;
}

void format(const MonitorCommand& command, std::string& out) {
  std::visit(Formatter{out}, command);
  out += ')';
}

}  // namespace cls::soccer
