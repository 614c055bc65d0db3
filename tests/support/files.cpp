// Finds and reads test files; zlib also reads plain files.
#include "tests/support/files.h"

#include <zlib.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace cls::tests {

namespace fs = std::filesystem;

fs::path source_folder() { return CLS_SOURCE_DIR; }

fs::path fixture(const std::string& name) { return source_folder() / "fixtures" / name; }

std::optional<fs::path> data(const std::string& name) {
  const char* named = std::getenv("CLS_DATA");
  const fs::path root =
      named != nullptr && *named != '\0' ? fs::path(named) : source_folder() / "../shared/data";
  const fs::path path = root / name;
  if (!fs::exists(path)) return std::nullopt;
  return path;
}

std::string read_file(const fs::path& path) {
  gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr) throw std::runtime_error("cannot open " + path.string());
  std::string content;
  std::array<char, 65536> block;
  int count = 0;
  while ((count = gzread(file, block.data(), block.size())) > 0) {
    content.append(block.data(), static_cast<std::size_t>(count));
  }
  const int end = gzclose(file);
  if (count < 0 || end != Z_OK) throw std::runtime_error("cannot read " + path.string());
  return content;
}

}  // namespace cls::tests
