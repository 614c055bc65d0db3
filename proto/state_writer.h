// Serializes States: one pass over the fields, several times as fast as the generated code.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "proto/playmaker.pb.h"

namespace cls::proto {

enum class StateForm : std::uint8_t {
  kWhole,
  /// LEAN_STATES of team_playmaker.proto: without the entries of our_players_dict and
  /// their_players_dict that equal the first player of `teammates` or `opponents` with that number.
  kLean,
};

/// Owns the memory of the bytes and reuses it.
class StateWriter {
 public:
  /// The bytes of `state`, as write_with_sorted_maps() writes them, valid until the next call.
  /// Fields that playmaker.proto does not have may be left out.
  std::string_view write(const protos::State& state, StateForm form);

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace cls::proto
