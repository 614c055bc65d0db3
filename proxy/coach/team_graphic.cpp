// Reads the strings of an XPM file and cuts them into tiles.
#include "proxy/coach/team_graphic.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string_view>

#include "base/index.h"
#include "base/io/whole_file.h"
#include "base/text/number_text.h"

namespace cls::proxy {
namespace {

using base::Error;
using base::Result;

constexpr int kTile = 8;
constexpr int kMaxWidth = 256;
constexpr int kMaxHeight = 64;
constexpr std::size_t kTileSize = kTile;

struct Picture {
  std::map<char, std::string> colors;  ///< the line of each
  std::vector<std::string> rows;
};

// The strings of the C array; comments are skipped.
std::vector<std::string> strings_in(std::string_view text) {
  std::vector<std::string> strings;
  while (true) {
    const std::size_t comment = text.find("/*");
    const std::size_t quote = text.find('"');
    if (quote == std::string_view::npos) return strings;

    if (comment < quote) {
      const std::size_t end = text.find("*/", comment);
      if (end == std::string_view::npos) return strings;
      text.remove_prefix(end + 2);
      continue;
    }

    const std::size_t end = text.find('"', quote + 1);
    if (end == std::string_view::npos) return strings;
    strings.emplace_back(text.substr(quote + 1, end - quote - 1));
    text.remove_prefix(end + 1);
  }
}

// "WIDTH HEIGHT COLORS CHARACTERS-PER-PIXEL".
std::optional<std::array<int, 4>> read_header(std::string_view line) {
  std::array<int, 4> numbers{};
  for (int& number : numbers) {
    const std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string_view::npos) return std::nullopt;
    line.remove_prefix(start);
    const std::size_t length = base::parse_int_prefix(line, number);
    if (length == 0) return std::nullopt;
    line.remove_prefix(length);
  }
  return numbers;
}

// Whether the header describes a team graphic, and as many lines as there are.
Result<void> check(const std::array<int, 4>& header, std::size_t lines) {
  const auto& [width, height, colors, characters] = header;
  if (characters != 1) {
    return Error{fmt::format("{} characters per pixel; a team graphic has 1", characters)};
  }
  const bool fits = width > 0 && height > 0 && width % kTile == 0 && height % kTile == 0 &&
                    width <= kMaxWidth && height <= kMaxHeight;

  if (!fits) {
    return Error{fmt::format("{} x {} pixels; a team graphic has multiples of {}, at most {} x {}",
                             width, height, kTile, kMaxWidth, kMaxHeight)};
  }

  const std::size_t named = 1 + base::index(std::max(colors, 0)) + base::index(height);
  if (colors < 1 || lines < named) {
    return Error{fmt::format("{} lines; its header names {}", lines, named)};
  }
  return {};
}

Result<Picture> read_picture(const std::vector<std::string>& strings) {
  if (strings.empty()) return Error{"no XPM file: it has no quoted text"};
  const auto header = read_header(strings.front());
  if (!header) return Error{fmt::format("no XPM header: \"{}\"", strings.front())};
  TRY(check(*header, strings.size()));
  const std::size_t width = base::index((*header)[0]);
  const std::size_t height = base::index((*header)[1]);
  const std::size_t colors = base::index((*header)[2]);

  Picture picture;
  for (std::size_t i = 1; i <= colors; ++i) {
    if (strings[i].empty()) return Error{fmt::format("color {} is empty", i)};
    picture.colors[strings[i].front()] = strings[i];
  }

  for (const std::string& row : std::span(strings).subspan(1 + colors, height)) {
    if (row.size() != width) {
      return Error{fmt::format("a row of {} pixels, not of {}", row.size(), width)};
    }
    for (const char pixel : row) {
      if (picture.colors.contains(pixel)) continue;
      return Error{fmt::format("a pixel '{}' without a color", pixel)};
    }
    picture.rows.push_back(row);
  }
  return picture;
}

soccer::TeamGraphic tile_at(const Picture& picture, std::size_t column, std::size_t row) {
  std::map<char, std::string> colors;
  std::vector<std::string> pixels;
  for (std::size_t y = 0; y < kTileSize; ++y) {
    pixels.push_back(picture.rows[row * kTileSize + y].substr(column * kTileSize, kTileSize));
    for (const char pixel : pixels.back()) colors[pixel] = picture.colors.at(pixel);
  }

  soccer::TeamGraphic tile;
  tile.x = static_cast<int>(column);
  tile.y = static_cast<int>(row);
  tile.xpm.push_back(fmt::format("{} {} {} 1", kTile, kTile, colors.size()));
  for (const auto& entry : colors) tile.xpm.push_back(entry.second);
  tile.xpm.insert(tile.xpm.end(), pixels.begin(), pixels.end());
  return tile;
}

}  // namespace

Result<TeamGraphic> read_team_graphic(const std::string& path) {
  if (const auto why = base::why_no_file(path)) return Error{fmt::format("{}: {}", path, *why)};
  const auto text = base::read_text(path);
  if (!text) return Error{fmt::format("{}: cannot be read", path)};
  const auto picture = read_picture(strings_in(*text));
  if (!picture) return Error{fmt::format("{}: {}", path, picture.error().message)};

  TeamGraphic tiles;
  for (std::size_t row = 0; row < picture->rows.size() / kTileSize; ++row) {
    for (std::size_t column = 0; column < picture->rows.front().size() / kTileSize; ++column) {
      tiles.push_back(tile_at(*picture, column, row));
    }
  }
  return tiles;
}

}  // namespace cls::proxy
