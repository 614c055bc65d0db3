// JSON values: the same texts, values and errors as nlohmann-json.
#include "base/text/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cls::base {
namespace {

using Library = nlohmann::ordered_json;

// The text of the exception that `operation` throws.
template <typename Exception, typename Operation>
std::string error_of(Operation operation) {
  try {
    operation();
  } catch (const Exception& error) {
    return error.what();
  }
  return "no exception";
}

const std::vector<std::string>& documents() {
  static const std::vector<std::string> texts = {
      "null",
      "true",
      "-3",
      "18446744073709551615",
      "9223372036854775808",
      "0.1",
      "1e300",
      "-0.0",
      R"("a \" \u00e9 \ud83d\ude00 \n")",
      "[]",
      "{}",
      R"([1, [2, [3.5, {}]], null, false])",
      R"({"b": 1, "a": {"c": [true, "x"], "d": null}, "b": 2})"};

  return texts;
}

TEST(Json, PrintsWhatTheLibraryPrints) {
  for (const std::string& text : documents()) {
    const Json json = Json::parse(text);
    const Library library = Library::parse(text);

    EXPECT_EQ(json.dump(), library.dump());
    EXPECT_EQ(json.dump(2), library.dump(2));
    EXPECT_EQ(json.dump(-1, true), library.dump(-1, ' ', true));
    EXPECT_STREQ(json.type_name(), library.type_name());
    EXPECT_EQ(json.size(), library.size());
  }
}

TEST(Json, ReplacesBytesThatAreNotUtf8) { EXPECT_EQ(Json("a\xff").dump(), "\"a\xef\xbf\xbd\""); }

TEST(Json, IsBuiltFromLists) {
  const std::map<std::string, int> counts = {{"x", 1}, {"y", 2}};
  const std::vector<std::string> names = {"red", "blue"};
  const Json json = {{"schema", "a/1"},       {"list", {1, 2.5, true}}, {"one", {{"key", nullptr}}},
                     {"pair", {"a", 1}},      {"names", names},         {"counts", counts},
                     {"empty", Json::array()}};

  EXPECT_EQ(json.dump(), R"({"schema":"a/1","list":[1,2.5,true],"one":{"key":null},)"
                         R"("pair":["a",1],"names":["red","blue"],)"
                         R"("counts":{"x":1,"y":2},"empty":[]})");
  EXPECT_EQ(json, Json::parse(json.dump()));
}

TEST(Json, AddsMembersAndElements) {
  Json json;
  json["list"].push_back(1);
  json["list"].push_back({{"a", 1}});
  json["name"] = "x";
  json["name"] = "y";
  json.update({{"more", 2}});
  json.erase("missing");

  EXPECT_EQ(json.dump(), R"({"list":[1,{"a":1}],"name":"y","more":2})");
  EXPECT_EQ(json["list"].back()["a"], 1);
  EXPECT_EQ(json.value("more", 0), 2);
  EXPECT_EQ(json.value("absent", "none"), "none");
  EXPECT_EQ(json.find("absent"), nullptr);
}

TEST(Json, ConvertsNumbers) {
  EXPECT_EQ(Json(-2.9).get<int>(), -2);
  EXPECT_EQ(Json(3).get<double>(), 3.0);
  EXPECT_EQ(Json(true).get<int>(), 1);
  EXPECT_EQ(Json(std::numeric_limits<std::uint64_t>::max()).get<std::uint64_t>(),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(Json::parse("[1, 2]").get<std::vector<int>>(), (std::vector<int>{1, 2}));
  EXPECT_EQ(Json(1), Json(1.0));
}

// The texts of these errors reach users.
TEST(Json, FailsAsTheLibraryDoes) {
  const std::string text = R"({"a": [1, "x"], "b": true})";
  const Json json = Json::parse(text);
  const Library library = Library::parse(text);
  const auto same = [&](auto operation) {
    const std::string expected = error_of<Library::exception>([&] { operation(library); });
    EXPECT_NE(expected, "no exception");
    EXPECT_EQ(error_of<Json::exception>([&] { operation(json); }), expected);
  };

  same([](const auto& value) { return value.at("c").size(); });
  same([](const auto& value) { return value.at("a").at(2).size(); });
  same([](const auto& value) { return value.at("a").at("b").size(); });
  same([](const auto& value) { return value.at("a").template get<int>(); });
  same([](const auto& value) { return value.at("b").template get<std::string>(); });
  same([](const auto& value) { return value.at("a").at(0).template get<bool>(); });
  same([](auto value) { value.push_back(1); });

  for (const char* wrong : {"", "{", "[1,]", "1e999", "\"\xff\""}) {
    const auto library_parse = [&] {
      const Library ignored = Library::parse(wrong);
      return ignored.size();
    };
    EXPECT_EQ(error_of<Json::exception>([&] { Json::parse(wrong); }),
              error_of<Library::exception>(library_parse));
    EXPECT_TRUE(Json::parse_or_discarded(wrong).is_discarded());
  }
}

TEST(Json, RefusesDeepNesting) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };

  EXPECT_EQ(Json::parse(nested(Json::kMaxDepth)).dump(), nested(Json::kMaxDepth));
  EXPECT_EQ(error_of<Json::exception>([&] { Json::parse(nested(1'000'000)); }),
            "values nest too deep");
  EXPECT_TRUE(Json::parse_or_discarded(nested(1'000'000)).is_discarded());
}

}  // namespace
}  // namespace cls::base
