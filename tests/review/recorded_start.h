// The beginning of a recorded match, with its statistics.
#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "analysis/statistics/match_statistics.h"
#include "gamelog/rcg/rcg_reader.h"
#include "tests/support/files.h"

namespace cls::review {

class RecordedStart : public testing::Test {
 protected:
  RecordedStart() {
    auto read = gamelog::read_rcg_file(tests::fixture("gamelog/match-start.rcg.gz").string());
    EXPECT_TRUE(read);
    record_ = *std::move(read);
    statistics_ = analysis::compute_statistics(record_, nullptr);
  }

  gamelog::MatchRecord record_;
  analysis::MatchStatistics statistics_;
};

}  // namespace cls::review
