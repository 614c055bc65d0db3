// Configuration syntax of rcssserver.
#include "soccer/parameters/configuration.h"

#include <gtest/gtest.h>

namespace cls::soccer {
namespace {

/// "module::name=value" of each item, or the error.
std::vector<std::string> read(std::string_view text) {
  const auto items = parse_configuration(text);
  if (!items) return {"error: " + items.error().message};
  std::vector<std::string> texts;
  for (const ConfigurationItem& item : *items) {
    texts.push_back(item.module + "::" + item.name + "=" + item.value);
  }
  return texts;
}

using Items = std::vector<std::string>;

TEST(Configuration, ParsesFilesOfRcssserver) {
  // The form of the files that rcssserver 19 creates.
  constexpr std::string_view kFile =
      "#########################################################\n"
      "# Configurations for server::\n"
      "#########################################################\n"
      "\n"
      "server::version = '19.0.0' \n"
      "\n"
      "# server::catch_ban_cycle\n"
      "server::catch_ban_cycle = 5\n"
      "server::coach = false\n"
      "server::fixed_teamname_l = ''\n"
      "server::landmark_file = '~/.rcssserver-landmark.xml'\n"
      "server::ball_decay = 0.94\n";

  EXPECT_EQ(read(kFile),
            (Items{"server::version=19.0.0", "server::catch_ban_cycle=5", "server::coach=false",
                   "server::fixed_teamname_l=", "server::landmark_file=~/.rcssserver-landmark.xml",
                   "server::ball_decay=0.94"}));
}

TEST(Configuration, AcceptsDashesSpacesCommentsAndQuotes) {
  EXPECT_EQ(read("--server::a=1 -player::b = -2.5e3"), (Items{"server::a=1", "player::b=-2.5e3"}));
  EXPECT_EQ(read("server::a /* x = y \n */ = // no\n 'b c'"), (Items{"server::a=b c"}));
  EXPECT_EQ(read("server::a=\"it's\"server::b=on"), (Items{"server::a=it's", "server::b=on"}));
  EXPECT_EQ(read("server::dir=./logs//x#1"), (Items{"server::dir=./logs//x#1"}));
  EXPECT_EQ(read("include='my.conf' --help server::help"),
            (Items{"::include=my.conf", "::help=", "server::help="}));
  EXPECT_EQ(read("server::a=2024abc"), (Items{"server::a=2024abc"}));
  EXPECT_TRUE(read(" \n # nothing").empty());
}

TEST(Configuration, ReportsLineOfError) {
  EXPECT_EQ(read("\n\nserver::a 1"),
            (Items{"error: line 3: 'server::a' is not of the form server::NAME=VALUE"}));
  EXPECT_EQ(read("server::a="), (Items{"error: line 1: 'server::a=' has no value"}));
  EXPECT_EQ(read("server::a='x"), (Items{"error: line 1: unterminated quote"}));
  EXPECT_EQ(read("server::a=1\n/* x"), (Items{"error: line 2: unterminated comment"}));
  EXPECT_EQ(read("=1"), (Items{"error: line 1: '=1' is not of the form server::NAME=VALUE"}));
  EXPECT_EQ(read("---server::a=1"),
            (Items{"error: line 1: '---server::a=1' is not of the form server::NAME=VALUE"}));
}

TEST(Configuration, JoinsArgumentsWithSpacesAsQuotedValues) {
  EXPECT_EQ(read(join_arguments({"server::a=./start.sh -x", "server::b=", "two items",
                                 "server::c = 'as it is'", "server::d", "=", "1"})),
            (Items{"server::a=./start.sh -x", "server::b=two items", "server::c=as it is",
                   "server::d=1"}));
}

}  // namespace
}  // namespace cls::soccer
