// rcssserver's configuration language.
#include "soccer/parameters/configuration.h"

#include <gtest/gtest.h>

namespace cls::soccer {
namespace {

/// "module::name=value" of every item, or the error.
std::vector<std::string> read(std::string_view text) {
  const auto items = parse_configuration(text);
  if (!items) return {"error: " + items.error().message};
  std::vector<std::string> words;
  for (const ConfigurationItem& item : *items) {
    words.push_back(item.module + "::" + item.name + "=" + item.value);
  }
  return words;
}

using Words = std::vector<std::string>;

TEST(Configuration, ReadsWhatTheRealServerWritesIntoItsFiles) {
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
            (Words{"server::version=19.0.0", "server::catch_ban_cycle=5", "server::coach=false",
                   "server::fixed_teamname_l=", "server::landmark_file=~/.rcssserver-landmark.xml",
                   "server::ball_decay=0.94"}));
}

TEST(Configuration, TakesDashesBlanksCommentsAndQuotes) {
  EXPECT_EQ(read("--server::a=1 -player::b = -2.5e3"), (Words{"server::a=1", "player::b=-2.5e3"}));
  EXPECT_EQ(read("server::a /* x = y \n */ = // no\n 'b c'"), (Words{"server::a=b c"}));
  EXPECT_EQ(read("server::a=\"it's\"server::b=on"), (Words{"server::a=it's", "server::b=on"}));
  EXPECT_EQ(read("server::dir=./logs//x#1"), (Words{"server::dir=./logs//x#1"}));
  EXPECT_EQ(read("include='my.conf' --help server::help"),
            (Words{"::include=my.conf", "::help=", "server::help="}));
  EXPECT_EQ(read("server::a=2024abc"), (Words{"server::a=2024abc"}));
  EXPECT_TRUE(read(" \n # nothing").empty());
}

TEST(Configuration, NamesTheLineOfAMistake) {
  EXPECT_EQ(read("\n\nserver::a 1"),
            (Words{"error: line 3: 'server::a' is not of the form server::NAME=VALUE"}));
  EXPECT_EQ(read("server::a="), (Words{"error: line 1: 'server::a=' has no value"}));
  EXPECT_EQ(read("server::a='x"), (Words{"error: line 1: a quote without an end"}));
  EXPECT_EQ(read("server::a=1\n/* x"), (Words{"error: line 2: a comment without an end"}));
  EXPECT_EQ(read("=1"), (Words{"error: line 1: '=1' is not of the form server::NAME=VALUE"}));
  EXPECT_EQ(read("---server::a=1"),
            (Words{"error: line 1: '---server::a=1' is not of the form server::NAME=VALUE"}));
}

TEST(Configuration, ACommandLineKeepsValuesWithBlanksWhole) {
  EXPECT_EQ(read(join_arguments({"server::a=./start.sh -x", "server::b=", "two words",
                                 "server::c = 'as it is'", "server::d", "=", "1"})),
            (Words{"server::a=./start.sh -x", "server::b=two words", "server::c=as it is",
                   "server::d=1"}));
}

}  // namespace
}  // namespace cls::soccer
