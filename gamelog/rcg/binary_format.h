// Layout of binary game logs (rcg versions 1 to 3) and binary monitor messages
// (docs/spec/log-formats.md 1.4 to 1.6).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::gamelog {

namespace rcg_binary {

/// The first two bytes of a record.
enum Kind : int {
  kNothing = 0,
  kShow = 1,
  kMessage = 2,
  kDraw = 3,
  kBlank = 4,
  kMode = 5,
  kTeams = 6,
  kType = 7,
  kServerParam = 8,
  kPlayerParam = 9,
};

// Sizes in bytes; those of shows do not include the kind.
constexpr std::size_t kKindSize = 2;
constexpr std::size_t kShortShowSize = 316;  // version 2
constexpr std::size_t kLongShowSize = 1428;  // version 3
constexpr std::size_t kNameSize = 16;
constexpr double kShortScale = 16.0;  // units per meter in short shows

}  // namespace rcg_binary

// Sizes of the parameter blocks (docs/spec/log-formats.md 1.6).
constexpr std::size_t kPlayerTypeSize = 88;
constexpr std::size_t kServerParamSize = 396;
constexpr std::size_t kPlayerParamSize = 132;

// Big-endian integers, and reals times 65536. Their bytes must be readable at `at`.
int read_int16(const char* at);
int read_int32(const char* at);
double read_real(const char* at);

// Each reads a block of the size above; parameters that it lacks keep their values.
void read_server_params(std::string_view block, soccer::ServerParams& params);
void read_player_params(std::string_view block, soccer::PlayerParams& params);
void read_player_type(std::string_view block, soccer::PlayerType& type);

// Each appends its bytes. Values are clamped to the range of the type.
enum class Rounding : std::uint8_t {
  kNearest,
  kTruncate,            ///< toward zero
  kAddHalfAndTruncate,  ///< adds 0.5, then toward zero, as rcssserver does
};
void write_int16(int value, std::string& out);
void write_int32(std::int64_t value, std::string& out);
void write_real(double value, Rounding rounding, std::string& out);

// Each appends a block of the size above; unused bytes are NUL.
void write_parameters(const soccer::ServerParams& params, std::string& out);
void write_parameters(const soccer::PlayerParams& params, std::string& out);
void write_parameters(const soccer::PlayerType& type, std::string& out);

}  // namespace cls::gamelog
