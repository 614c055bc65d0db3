// Reads debug logs, whole or from an offset on.
#include "viewer/page/page_drawings.h"

#include <algorithm>
#include <fstream>

#include "base/index.h"
#include "base/io/whole_file.h"
#include "viewer/decisions/decision_files.h"
#include "viewer/page/encoding.h"

namespace cls::viewer {

std::filesystem::path drawings_file(const std::filesystem::path& folder, soccer::Side side) {
  return folder / (side == soccer::Side::kRight ? kRightDebugFile : kLeftDebugFile);
}

std::vector<PageDrawings> read_page_drawings(const std::filesystem::path& folder) {
  std::vector<PageDrawings> drawings;
  for (const soccer::Side side : {soccer::Side::kLeft, soccer::Side::kRight}) {
    const auto lines = base::read_file(drawings_file(folder, side));
    if (lines && !lines->empty()) drawings.push_back({side, gzip(*lines)});
  }
  return drawings;
}

std::string read_drawings(const std::filesystem::path& folder, soccer::Side side, std::size_t from,
                          std::size_t max) {
  std::ifstream file(drawings_file(folder, side), std::ios::binary);
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(drawings_file(folder, side), code);
  if (!file || code || from >= size) return {};

  std::string bytes(std::min<std::size_t>(max, size - from), '\0');
  file.seekg(static_cast<std::streamoff>(from));
  file.read(bytes.data(), std::ssize(bytes));
  bytes.resize(base::index(std::max<std::streamsize>(0, file.gcount())));
  return bytes;
}

}  // namespace cls::viewer
