// Conversations that make no sense harm nobody: the short form of the fuzzer.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "soccer/random.h"
#include "tests/fuzz/session_script.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

std::vector<std::string> seeds() {
  std::vector<std::string> scripts;
  for (const auto& entry : std::filesystem::directory_iterator(fixture("fuzz/session"))) {
    scripts.push_back(read_file(entry.path()));
  }
  std::sort(scripts.begin(), scripts.end());
  return scripts;
}

TEST(SessionScript, TheSeedsOfTheFuzzerPlay) {
  const auto scripts = seeds();
  EXPECT_GE(scripts.size(), 4u);
  for (const std::string& script : scripts) play_session_script(script);
}

TEST(SessionScript, DamagedOnesPlayToo) {
  const auto scripts = seeds();
  soccer::RandomStream random(1, "session script");
  const auto below = [&random](std::size_t n) {
    return static_cast<std::size_t>(random.uniform(0.0, 1.0) * static_cast<double>(n));
  };
  for (int i = 0; i < 300; ++i) {
    std::string script = scripts[below(scripts.size())];
    for (int k = 0; k < 8; ++k) {
      const std::size_t at = below(script.size());
      switch (below(4)) {
        case 0:
          script[at] = static_cast<char>(below(256));
          break;
        case 1:
          script.erase(at, below(20));
          break;
        case 2:
          script.insert(at, script.substr(below(script.size()), below(40)));
          break;
        default:
          script.insert(at, std::to_string(static_cast<int>(below(100000)) - 50000));
      }
      if (script.empty()) script = "c";
    }
    play_session_script(script);
  }
}

}  // namespace
}  // namespace cls::tests
