// Commands of monitors.
#include <gtest/gtest.h>

#include "soccer/commands/monitor_command.h"

namespace cls::soccer {
namespace {

template <typename Command>
Command read(std::string_view text) {
  const auto command = parse_monitor_command(text);
  EXPECT_TRUE(command && std::holds_alternative<Command>(*command)) << text;
  return std::get<Command>(*command);
}

TEST(MonitorCommand, ParsesPositionsInSixteenthsAndSidesAsSigns) {
  read<DispStart>("(dispstart)");
  read<DispBye>("(dispbye)");
  const auto foul = read<DispFoul>("(dispfoul -160 80 -1)");

  EXPECT_EQ(foul.position, (Vec2{-10.0, 5.0}));
  EXPECT_EQ(foul.side, Side::kRight);
  EXPECT_EQ(read<DispFoul>("(dispfoul 8 0 0)").side, Side::kNeutral);

  const auto placed = read<DispPlayer>("(dispplayer 1 11 -8 16 -90)");
  EXPECT_EQ(placed.side, Side::kLeft);
  EXPECT_EQ(placed.unum, 11);
  EXPECT_EQ(placed.position, (Vec2{-0.5, 1.0}));
  EXPECT_EQ(placed.body, -90.0);
  EXPECT_EQ(read<DispDiscard>("(dispdiscard -1 3)").unum, 3);
  EXPECT_TRUE(read<DispCard>("(dispcard 1 3 red)").red);
  EXPECT_FALSE(read<DispCard>("(dispcard 1 3 yellow)").red);
  EXPECT_EQ(read<Compression>("(compression 6)").level, 6);
}

TEST(MonitorCommand, RejectsUnknownCommands) {
  for (const char* text :
       {"", "(", "dispstart", "(foo)", "(dispfoul)", "(dispfoul 1 2)", "(dispfoul a b c)",
        " (dispstart)", "( dispfoul 1 2 1)", "(dispstart)x", "(dispdiscard 1)",
        "(dispcard 1 1 green)", "(dispcard 1 1)", "(compression)"}) {
    EXPECT_FALSE(parse_monitor_command(text)) << text;
  }
}

TEST(MonitorCommand, MapsUnknownPlayersToNeutralSide) {
  for (const char* text : {"(dispplayer 1 12 0 0 0)", "(dispplayer 1 0 0 0 0)",
                           "(dispplayer 2 1 0 0 0)", "(dispplayer 0 1 0 0 0)"}) {
    EXPECT_EQ(read<DispPlayer>(text).side, Side::kNeutral) << text;
  }
}

TEST(MonitorCommand, FormatsLikeMonitors) {
  for (const char* text : {"(dispstart)", "(dispbye)", "(dispfoul -160 80 -1)", "(dispfoul 0 0 0)",
                           "(dispfoul 1 2 1)", "(dispplayer -1 11 -8 16 -90)", "(dispdiscard 1 3)",
                           "(dispcard -1 3 red)", "(dispcard 1 3 yellow)", "(compression 9)"}) {
    std::string written;
    format(*parse_monitor_command(text), written);
    EXPECT_EQ(written, text);
  }
}

}  // namespace
}  // namespace cls::soccer
