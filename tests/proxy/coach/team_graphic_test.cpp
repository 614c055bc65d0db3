// XPM files as tiles.
#include "proxy/coach/team_graphic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace cls::proxy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class TeamGraphicFile : public testing::Test {
 protected:
  std::string file(const std::string& text) const {
    const std::string path = (folder_.path() / "logo.xpm").string();
    std::ofstream(path) << text;
    return path;
  }
  std::string error_of(const std::string& text) const {
    const auto read = read_team_graphic(file(text));
    return read ? "" : read.error().message;
  }

  tests::TemporaryFolder folder_;
};

std::string rows(int count, const std::string& row) {
  std::string text;
  for (int i = 0; i < count; ++i) text += "\"" + row + "\",\n";
  return text;
}

TEST_F(TeamGraphicFile, BecomesTilesWithTheirOwnColors) {
  const auto tiles = read_team_graphic(
      file("/* XPM */\nstatic char *a[] = {\n/* columns \"rows\" */\n\"16 8 3 1\",\n\"a c red\",\n"
           "\"b c blue\",\n\"  c black\",\n/* pixels */\n" +
           rows(8, "aaaaaaaa bbbbbbb") + "};\n"));

  ASSERT_TRUE(tiles) << tiles.error().message;
  ASSERT_EQ(tiles->size(), 2U);
  EXPECT_THAT((*tiles)[0].xpm,
              ElementsAre("8 8 1 1", "a c red", "aaaaaaaa", "aaaaaaaa", "aaaaaaaa", "aaaaaaaa",
                          "aaaaaaaa", "aaaaaaaa", "aaaaaaaa", "aaaaaaaa"));
  EXPECT_EQ((*tiles)[1].x, 1);
  EXPECT_EQ((*tiles)[1].y, 0);
  EXPECT_EQ((*tiles)[1].xpm.front(), "8 8 2 1");
}

TEST_F(TeamGraphicFile, NamesWhatIsWrong) {
  EXPECT_THAT(read_team_graphic("no/such.xpm").error().message, HasSubstr("no/such.xpm: "));
  EXPECT_THAT(error_of("P6 1 1"), HasSubstr("logo.xpm: no XPM file"));
  EXPECT_THAT(error_of("{\"a b\"}"), HasSubstr("no XPM header: \"a b\""));
  EXPECT_THAT(error_of("\"8 8 1 2\"" + rows(9, "x")), HasSubstr("2 characters per pixel"));
  EXPECT_THAT(error_of("\"12 8 1 1\"" + rows(9, "x")), HasSubstr("12 x 8 pixels"));
  EXPECT_THAT(error_of("\"264 8 1 1\"" + rows(9, "x")), HasSubstr("264 x 8 pixels"));
  EXPECT_THAT(error_of("\"8 8 1 1\"" + rows(3, "x")), HasSubstr("4 lines; its header names 10"));
  EXPECT_THAT(error_of("\"8 8 1 1\",\"a c red\"," + rows(8, "aaa")),
              HasSubstr("a row of 3 pixels"));
  EXPECT_THAT(error_of("\"8 8 1 1\",\"a c red\"," + rows(8, "aaaaaaab")),
              HasSubstr("a pixel 'b' without a color"));
  EXPECT_THAT(error_of("\"8 8 9999999 1\",\"a c red\""), HasSubstr("2 lines"));
}

}  // namespace
}  // namespace cls::proxy
