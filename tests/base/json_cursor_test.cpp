// The JSON pull parser compared with nlohmann::json on random documents.
#include "base/text/json_cursor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

namespace cls::base {
namespace {

using Json = nlohmann::ordered_json;

class RandomDocument {
 public:
  explicit RandomDocument(unsigned seed) : random_(seed) {}

  Json value(int depth) {
    switch (pick(depth > 0 ? 7 : 5)) {
      case 0:
        return pick(2) == 0;
      case 1:
        return nullptr;
      case 2:
        return pick(2'000'000) - 1'000'000;
      case 3:
        return std::round((pick(2'000'000) - 1'000'000) * 10.0) / 1e4;
      case 4:
        return text();

      case 5: {
        Json list = Json::array();
        for (int i = pick(4); i > 0; --i) list.push_back(value(depth - 1));
        return list;
      }

      default: {
        Json object = Json::object();
        for (int i = pick(4); i > 0; --i) object[text()] = value(depth - 1);
        return object;
      }
    }
  }

 private:
  int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  std::string text() {
    static const std::vector<std::string> parts = {"a",  " ",  "\"", "\\",       "\n",
                                                   "\t", "\b", "{",  "\xc3\xa4", "\xe2\x82\xac"};
    std::string text;
    for (int i = pick(6); i > 0; --i) {
      text += parts[static_cast<std::size_t>(pick(static_cast<int>(parts.size())))];
    }
    return text;
  }

  std::mt19937 random_;
};

/// Parses any value with the cursor; numbers have single precision.
Json parse(JsonCursor& in) {
  switch (in.peek()) {
    case '{': {
      Json object = Json::object();
      std::string_view key;
      in.open('{');
      while (in.next_key(key)) {
        const std::string name = JsonCursor::unescape(key);
        object[name] = parse(in);
      }
      return object;
    }

    case '[': {
      Json list = Json::array();
      in.open('[');
      while (in.next_element()) list.push_back(parse(in));
      return list;
    }

    case '"': {
      std::string text;
      in.string(text);
      return text;
    }

    case 'n':
      in.skip_value();
      return nullptr;
    case 't':
    case 'f': {
      std::string text;
      in.scalar_text(text);
      return text == "1";
    }

    default: {
      double value = 0.0;
      in.number(value);
      return value;
    }
  }
}

/// `json` with all numbers in single precision.
Json in_single_precision(const Json& json) {
  if (json.is_number()) return static_cast<double>(json.get<float>());
  Json result = json;
  for (Json& child : result) {
    if (json.is_structured()) child = in_single_precision(child);
  }
  return result;
}

// A line feed and 64 readable bytes must follow the text.
std::string padded(const std::string& text) { return text + std::string(80, '\n'); }

TEST(JsonCursor, MatchesNlohmannOnRandomDocuments) {
  for (unsigned seed = 0; seed < 5000; ++seed) {
    const Json expected = RandomDocument(seed).value(5);
    const std::string text = expected.dump(-1, ' ', seed % 2 == 0);
    const std::string bytes = padded(text);
    JsonCursor in(std::string_view(bytes).substr(0, text.size()));
    const Json actual = parse(in);
    ASSERT_TRUE(in.good()) << text;
    ASSERT_TRUE(in.at_end()) << text;
    ASSERT_EQ(actual, in_single_precision(expected)) << text;
  }
}

TEST(JsonCursor, SkipsRandomValues) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const std::string text = RandomDocument(seed).value(5).dump();
    const std::string bytes = padded(text);
    JsonCursor in(std::string_view(bytes).substr(0, text.size()));
    ASSERT_TRUE(in.skip_value()) << text;
    ASSERT_TRUE(in.at_end()) << text;
  }
}

}  // namespace
}  // namespace cls::base
