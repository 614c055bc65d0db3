// The side at fault when a match was too slow.
#include "match/match_fault.h"

#include <gtest/gtest.h>

namespace cls::match {
namespace {

ProcessResult process(const std::string& name, double cpu_seconds, double delayed_seconds) {
  ProcessResult result;
  result.name = name;
  result.cpu_seconds = cpu_seconds;
  result.delayed_seconds = delayed_seconds;
  return result;
}

TEST(ProcessorTimeTest, IsThatOfTheProgramsOfASide) {
  const std::vector<ProcessResult> processes = {
      process("left player 1", 1.0, 3.0), process("left coach", 0.5, 0.5),
      process("right Playmaker", 4.0, 0.1), process("soccer server", 9.0, 9.0)};
  EXPECT_DOUBLE_EQ(processor_time(processes, soccer::Side::kLeft).used_s, 1.5);
  EXPECT_DOUBLE_EQ(processor_time(processes, soccer::Side::kLeft).delayed_s, 3.5);
  EXPECT_DOUBLE_EQ(processor_time(processes, soccer::Side::kRight).used_s, 4.0);
}

// 6.0 s against 18.3 s: 40 busy processes of the opponent took the processors.
TEST(ProcessorTimeTest, TellsWhoWasStarved) {
  EXPECT_TRUE(was_starved({6.0, 40.0}, {18.3, 60.0}));
  EXPECT_FALSE(was_starved({6.0, 1.0}, {18.3, 60.0})) << "it slept";
  EXPECT_FALSE(was_starved({0.0, 0.0}, {5.0, 0.0})) << "it slept";
  EXPECT_FALSE(was_starved({6.0, 12.0}, {7.0, 14.0})) << "both had too few processors";
  EXPECT_FALSE(was_starved({18.3, 60.0}, {6.0, 40.0})) << "it took them itself";
}

}  // namespace
}  // namespace cls::match
