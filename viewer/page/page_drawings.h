// The texts and drawings of Playmakers in a match folder, for its page.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "soccer/side.h"
#include "viewer/page/page.h"

namespace cls::viewer {

/// Where the debug log of a side is (decision_files.h).
std::filesystem::path drawings_file(const std::filesystem::path& folder, soccer::Side side);

/// The debug logs of a match folder. A side that showed nothing is left out.
std::vector<PageDrawings> read_page_drawings(const std::filesystem::path& folder);

/// Up to `max` bytes of the debug log of a side from the offset `from` on, while it grows or later.
std::string read_drawings(const std::filesystem::path& folder, soccer::Side side, std::size_t from,
                          std::size_t max);

}  // namespace cls::viewer
