// What was wrong with a log, and where.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cls::gamelog {

/// One place where a log is not what it should be.
struct Damage {
  std::uint64_t line = 0;  ///< from 1; 0 in binary logs
  std::uint64_t byte = 0;  ///< from 0, in the unpacked log
  int cycle = 0;           ///< of the last frame before it
  std::string what;
};

/// "game.rcg: line 12, byte 3456, cycle 7: expected a number".
std::string to_text(std::string_view path, const Damage& damage);

/// The first places, and how many there were.
struct DamageList {
  static constexpr std::size_t kKept = 20;

  std::vector<Damage> first;
  std::uint64_t count = 0;

  void add(Damage damage);
  /// The same, but what lies at the place that was added last is the reason of that.
  void add_reason(Damage damage);
  bool empty() const { return count == 0; }
};

}  // namespace cls::gamelog
