// The corpus of the fuzzer `view`.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/fuzz/view_checks.h"
#include "tests/support/files.h"
#include "viewer/decisions/decision_reader.h"
#include "viewer/stream/chunk_reader.h"

namespace cls::tests {
namespace {

TEST(ViewCorpus, KeepsThePromises) {
  int matches = 0;
  int decisions = 0;
  for (const auto& file : std::filesystem::directory_iterator(fixture("fuzz/view"))) {
    SCOPED_TRACE(file.path().filename().string());
    const std::string bytes = read_file(file.path());
    check_view(bytes);
    if (viewer::read_decisions(bytes)) ++decisions;
    viewer::ChunkReader reader;
    if (reader.add(bytes) && reader.match().record.frames() > 0) ++matches;
  }
  EXPECT_GE(matches, 2);
  EXPECT_GE(decisions, 1);
}

}  // namespace
}  // namespace cls::tests
