// The fast number scanner compared with the exact parser, on all forms in logs and on invalid
// input.
#include "base/text/number_scan.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <random>
#include <string>

#include "base/text/number_text.h"

namespace cls::base {
namespace {

constexpr std::size_t kLookAhead = 64;

struct Scanned {
  bool ok;
  float value;
  std::size_t length;
};

Scanned scan(std::string text) {
  const std::size_t size = text.size();
  text.append(kLookAhead, '\n');
  const char* at = text.data();
  float value = 0.0F;
  const bool ok = scan_number(at, value);
  EXPECT_LE(at, text.data() + size);
  return {ok, value, static_cast<std::size_t>(at - text.data())};
}

std::string printed(float value) {
  std::string text;
  append_g(value, text);
  return text;
}

TEST(ScanNumber, ReadsNumbersOfShowLines) {
  EXPECT_EQ(scan("-50.5897 1").value, -50.5897F);
  EXPECT_EQ(scan("-50.5897 1").length, 8u);
  EXPECT_EQ(scan("0.980041)").value, 0.980041F);
  EXPECT_EQ(scan("6107.07 ").value, 6107.07F);
  EXPECT_EQ(scan("130600)").value, 130600.0F);
  EXPECT_EQ(scan("8000 ").value, 8000.0F);
  EXPECT_EQ(scan("1e-05 ").value, 1e-05F);
  EXPECT_EQ(scan("2.5e+06)").value, 2.5e6F);
}

TEST(ScanNumber, ReadsOneDigitBeforeAnyEnd) {
  for (int digit = 0; digit <= 9; ++digit) {
    for (const char* end : {" ", ")", "  8", "))", "}", ",", "(", "p", "\n"}) {
      std::string text = std::to_string(digit) + end;
      const Scanned result = scan(text);
      EXPECT_TRUE(result.ok) << text;
      EXPECT_EQ(result.value, static_cast<float>(digit)) << text;
      EXPECT_EQ(result.length, 1u) << text;

      text.append(kLookAhead, '\n');
      const char* at = text.data();
      std::int32_t integer = -1;
      EXPECT_TRUE(scan_integer(at, integer)) << text;
      EXPECT_EQ(integer, digit) << text;
      EXPECT_EQ(at, text.data() + 1) << text;
    }
  }
}

TEST(ScanNumber, PreservesNegativeZero) {
  EXPECT_TRUE(std::signbit(scan("-0 ").value));
  EXPECT_FALSE(std::signbit(scan("0 ").value));
}

TEST(ScanNumber, MatchesParserForAllMagnitudes) {
  double magnitude = 1.234567e-5;
  for (int i = 0; i < 2000; ++i, magnitude *= 1.0127) {
    for (const double sign : {1.0, -1.0}) {
      std::string text;
      append_g(sign * magnitude, text);
      const Scanned result = scan(text + " 7");
      ASSERT_TRUE(result.ok) << text;
      ASSERT_EQ(result.length, text.size()) << text;
      ASSERT_EQ(result.value, static_cast<float>(*parse_number(text))) << text;
      ASSERT_EQ(printed(result.value), text);
    }
  }
}

TEST(ScanNumber, ReadsLongNumbersCompletely) {
  for (const char* text : {"1234567", "12345678", "123456789", "0.1234567", "1.23456789012345678",
                           "00000000012.5", "-12345.6789", "999999.9999999"}) {
    const Scanned result = scan(std::string(text) + ")");
    EXPECT_TRUE(result.ok) << text;
    EXPECT_EQ(result.length, std::string(text).size()) << text;
    EXPECT_EQ(result.value, static_cast<float>(*parse_number(text))) << text;
  }
}

TEST(ScanNumber, RejectsInvalidNumbers) {
  for (const char* text :
       {"", "-", ".5x", "nan", "-nan", "inf", "x1", ")", " 1", "1e30", "p", "-1e10"}) {
    const Scanned result = scan(text);
    if (std::string(text) == ".5x") {
      EXPECT_EQ(result.length, 2u);
      continue;
    }
    EXPECT_FALSE(result.ok) << text;
    EXPECT_EQ(result.length, 0u) << text;
  }
}

TEST(ScanNumber, StopsAfterTheNumber) {
  EXPECT_EQ(scan("12p4 ").length, 2u);
  EXPECT_EQ(scan("1.p ").length, 1u);
  EXPECT_EQ(scan("1.2.3 ").length, 3u);
  EXPECT_EQ(scan("5}").value, 5.0F);
  EXPECT_EQ(scan("5}").length, 1u);
}

TEST(ScanNumber, MatchesFromCharsOnRandomNumbers) {
  std::mt19937 random(1);

  for (int i = 0; i < 200'000; ++i) {
    const double magnitude = std::ldexp(random() / 4294967296.0, static_cast<int>(random() % 29));
    std::string text;
    append_g(random() % 2 == 0 ? magnitude : -magnitude, text);
    float expected = 0.0F;
    std::from_chars(text.data(), text.data() + text.size(), expected);
    ASSERT_EQ(scan(text + ")").value, expected) << text;
  }
}

TEST(ScanInteger, ReadsIntegersOfAllLengths) {
  for (const char* text : {"0", "7", "654", "130600", "1234567", "12345678", "2147483647", "-12"}) {
    std::string padded = std::string(text) + " 9";
    padded.append(kLookAhead, '\n');
    const char* at = padded.data();
    std::int32_t value = 0;
    EXPECT_TRUE(scan_integer(at, value)) << text;
    EXPECT_EQ(value, std::stoi(text));
    EXPECT_EQ(at, padded.data() + std::string(text).size());
  }
}

TEST(ScanInteger, RejectsNonNumbers) {
  for (const char* text : {"", "x", "pppp", ")", "-"}) {
    std::string padded = text;
    padded.append(kLookAhead, '\n');
    const char* at = padded.data();
    std::int32_t value = 0;
    EXPECT_FALSE(scan_integer(at, value)) << text;
  }
}

}  // namespace
}  // namespace cls::base
