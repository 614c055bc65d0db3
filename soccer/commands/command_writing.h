// What the writers of player, coach and trainer commands share.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <variant>

#include "base/text/number_text.h"
#include "soccer/commands/player_command.h"

namespace cls::soccer {

// All of these append to `out` and return false when something cannot be said.

inline bool write_text(std::string_view text, std::string& out) {
  out.append(text);
  return true;
}

/// A blank and the number.
inline bool write_number(double value, std::string& out) {
  if (!std::isfinite(value)) return false;
  out.push_back(' ');
  base::append_shortest(value, out);
  return true;
}

inline bool write(const Compression& c, std::string& out) {
  out.append("(compression ");
  base::append_int(c.level, out);
  return write_text(")", out);
}

inline bool write(Done, std::string& out) { return write_text("(done)", out); }
inline bool write(Bye, std::string& out) { return write_text("(bye)", out); }

/// A command of several kinds by the `write_one` of its kind; `out` is as it was when it is false.
template <typename Command, typename Write>
bool write_whole(const Command& command, std::string& out, Write write_one) {
  const std::size_t size = out.size();
  const bool written = std::visit([&](const auto& one) { return write_one(one, out); }, command);
  if (!written) out.resize(size);
  return written;
}

}  // namespace cls::soccer
