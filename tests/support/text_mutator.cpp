// Random mutations of texts.
#include "tests/support/text_mutator.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "tests/support/files.h"

namespace cls::tests {

std::vector<std::string> fuzz_seeds(const std::string& kind) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(fixture("fuzz") / kind)) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> seeds;
  for (const auto& path : paths) seeds.push_back(read_file(path));
  return seeds;
}

std::string TextMutator::mutate(std::string bytes, int max) {
  constexpr const char* kOddNumbers[] = {"-1", "0", "12", "99", "1e308", "-2147483648", "nan"};
  const int changes = 1 + static_cast<int>(next(static_cast<std::size_t>(max)));
  for (int i = 0; i < changes && !bytes.empty(); ++i) {
    const std::size_t at = next(bytes.size());
    switch (next(6)) {
      case 0:
        bytes[at] = static_cast<char>(next(256));
        break;
      case 1:
        bytes.resize(at);
        break;
      case 2:
        bytes.erase(at, 1 + next(20));
        break;
      case 3:
        bytes.insert(at, bytes.substr(next(bytes.size()), next(60)));
        break;
      case 4: {
        // Replace a number.
        const std::size_t digit = bytes.find_first_of("0123456789", at);
        if (digit == std::string::npos) break;
        const std::size_t end =
            std::min(bytes.find_first_not_of("0123456789.", digit), bytes.size());
        bytes.replace(digit, end - digit, kOddNumbers[next(std::size(kOddNumbers))]);
        break;
      }
      default:
        bytes.insert(at, 1, "()\" \n-9.e{}[],:\\"[next(16)]);
        break;
    }
  }

  return bytes;
}

}  // namespace cls::tests
