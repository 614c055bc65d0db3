// Parameters as version 3 logs hold them: fixed places in binary blocks.
#pragma once

#include <cstddef>
#include <string_view>

#include "soccer/player_params.h"
#include "soccer/player_type.h"
#include "soccer/server_params.h"

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

}  // namespace cls::gamelog
