// Helpers for formatting player, coach and trainer commands.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <variant>

#include "base/text/number_text.h"
#include "soccer/commands/player_command.h"
#include "soccer/protocol/text_writer.h"

namespace cls::soccer {

// All functions append to `out` and return false for commands that the grammar cannot express.

inline bool write_text(std::string_view text, std::string& out) {
  out.append(text);
  return true;
}

/// A space and the number.
inline bool write_number(double value, std::string& out) {
  if (!std::isfinite(value)) return false;
  out.push_back(' ');
  base::append_shortest(value, out);
  return true;
}

/// Texts and whole numbers, one after the other.
template <typename... Pieces>
bool write_pieces(std::string& out, const Pieces&... pieces) {
  append(out, pieces...);
  return true;
}

inline bool write(const Compression& c, std::string& out) {
  return write_pieces(out, "(compression ", c.level, ')');
}

inline bool write(Done, std::string& out) { return write_text("(done)", out); }
inline bool write(Bye, std::string& out) { return write_text("(bye)", out); }

/// Writes the alternative of a variant with `write_one`; leaves `out` unchanged on failure.
template <typename Command, typename Write>
bool write_command(const Command& command, std::string& out, Write write_one) {
  const std::size_t size = out.size();
  const bool written = std::visit([&](const auto& one) { return write_one(one, out); }, command);
  if (!written) out.resize(size);
  return written;
}

}  // namespace cls::soccer
