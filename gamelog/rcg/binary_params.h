// Parameters as version 3 logs and version 2 monitors have them: fixed places in binary blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "soccer/parameters/player_params.h"
#include "soccer/parameters/player_type.h"
#include "soccer/parameters/server_params.h"

namespace cls::gamelog {

// Sizes of the blocks (log-formats 1.6).
constexpr std::size_t kPlayerTypeSize = 88;
constexpr std::size_t kServerParamSize = 396;
constexpr std::size_t kPlayerParamSize = 132;

// Big-endian integers, and reals times 65536. Behind `at` there must be as many bytes.
int read_int16(const char* at);
int read_int32(const char* at);
double read_real(const char* at);

// Each takes a block of the size above; what it does not hold keeps its value.
void read_server_params(std::string_view block, soccer::ServerParams& params);
void read_player_params(std::string_view block, soccer::PlayerParams& params);
void read_player_type(std::string_view block, soccer::PlayerType& type);

// The other way: each appends its bytes. What is out of a number's range is cut to it.
enum class Rounding : std::uint8_t {
  kNearest,
  kCut,        ///< towards zero
  kHalfAndCut  ///< a half is added, then towards zero
};
void write_int16(int value, std::string& out);
void write_int32(std::int64_t value, std::string& out);
void write_real(double value, Rounding rounding, std::string& out);

// Each appends a block of the size above; spare places are NUL.
void write_server_params(const soccer::ServerParams& params, std::string& out);
void write_player_params(const soccer::PlayerParams& params, std::string& out);
void write_player_type(const soccer::PlayerType& type, std::string& out);

}  // namespace cls::gamelog
