// The seeds of the fuzzers, whole and broken in a thousand ways, through the fuzzers' checks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/fuzz/log_checks.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

std::vector<std::string> seeds(const char* kind) {
  std::vector<std::string> result;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(fixture("fuzz") / kind)) {
    paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  for (const auto& path : paths) result.push_back(read_file(path));
  EXPECT_GE(result.size(), 3u);
  return result;
}

// A small generator of its own: the same damage on every machine.
class Damager {
 public:
  std::string damage(std::string bytes) {
    const int changes = 1 + static_cast<int>(next(4));
    for (int i = 0; i < changes && !bytes.empty(); ++i) {
      const std::size_t at = next(bytes.size());
      switch (next(5)) {
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
        default:
          bytes.insert(at, 1, "()\" \n-9.e{}[],:\\"[next(16)]);
          break;
      }
    }
    return bytes;
  }

 private:
  std::size_t next(std::size_t below) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state_ >> 33) % below;
  }

  std::uint64_t state_ = 7;
};

void check_seeds(const char* kind, void (*check)(std::string_view), int variants) {
  Damager damager;
  for (const std::string& seed : seeds(kind)) {
    check(seed);
    for (int i = 0; i < variants; ++i) check(damager.damage(seed));
  }
}

TEST(FuzzCorpus, GameLogsKeepTheirPromisesHoweverDamaged) {
  check_seeds("rcg", check_game_log, 80);
}

TEST(FuzzCorpus, TextLogsKeepTheirPromisesHoweverDamaged) {
  check_seeds("rcl", check_text_log, 300);
}

}  // namespace
}  // namespace cls::tests
