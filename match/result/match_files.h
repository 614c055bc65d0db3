// What a match folder has, while the match is played and afterwards.
#pragma once

#include <filesystem>

namespace cls::match {

/// The game log of a match folder, plain or gzip; match.rcg if there is none yet.
std::filesystem::path game_log_in(const std::filesystem::path& folder);

/// True once the match of a folder has its result.
bool has_result(const std::filesystem::path& folder);

}  // namespace cls::match
