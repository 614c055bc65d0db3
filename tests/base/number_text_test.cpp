// Number formatting and parsing compared with printf's %g and strtod.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "base/text/number_text.h"
#include "base/text/rounded_number.h"

namespace cls::base {
namespace {

std::string formatted(double value) {
  std::string text;
  append_g(value, text);
  return text;
}

std::string printf_g(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

TEST(NumberText, FormatsNumbersLikeRcssserver) {
  EXPECT_EQ(formatted(130600), "130600");
  EXPECT_EQ(formatted(0.0), "0");
  EXPECT_EQ(formatted(-0.0), "-0");
  EXPECT_EQ(formatted(125.0959631642844), "125.096");
  EXPECT_EQ(formatted(0.00645004), "0.00645004");
  EXPECT_EQ(formatted(-0.349066), "-0.349066");
  EXPECT_EQ(formatted(1e-5), "1e-05");
  EXPECT_EQ(formatted(55.7), "55.7");
  EXPECT_EQ(formatted(90), "90");
}

TEST(NumberText, FormatsBoundaryValuesLikePrintf) {
  for (const double value : {0.1,
                             0.5,
                             1.0,
                             9.999995,
                             9.9999949999,
                             99999.95,
                             999999.0,
                             999999.4,
                             999999.5,
                             999999.6,
                             1e6,
                             1234567.0,
                             0.0001,
                             0.00009999995,
                             0.000099999949,
                             0.00001,
                             123456.5,
                             123457.5,
                             0.1234565,
                             0.1234575,
                             1e21,
                             1e-300,
                             1e300,
                             5e-324,
                             1.7976931348623157e308,
                             2.5,
                             100000.5,
                             1000005.0,
                             0.30000000000000004,
                             1.0 / 3.0,
                             2.0 / 3.0}) {
    EXPECT_EQ(formatted(value), printf_g(value));
    EXPECT_EQ(formatted(-value), printf_g(-value));
  }

  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(formatted(infinity), "inf");
  EXPECT_EQ(formatted(-infinity), "-inf");
}

// Values of all kinds in sensor messages, ties between two roundings, and arbitrary bits.
class RandomValues {
 public:
  double next(int kind) {
    const double uniform = std::ldexp(static_cast<double>(engine_() >> 11), -53);
    const auto steps =
        static_cast<double>(static_cast<std::int64_t>(engine_() % 4000000) - 2000000);

    switch (kind) {
      case 0:
        return std::rint(steps / 10) * 0.1;
      case 1:
        return steps * 0.0001;
      case 2:
        return (uniform - 0.5) * 240;
      case 3:
        return uniform * std::pow(10.0, static_cast<double>(engine_() % 16) - 8);
      case 4: {  // a tie, or a neighbor of a tie
        const double tie =
            (std::fabs(steps) + 0.5) / std::pow(10.0, static_cast<double>(engine_() % 9));
        const std::uint64_t choice = engine_() % 3;
        return choice == 0 ? tie : std::nextafter(tie, choice == 1 ? 0.0 : 1e9);
      }
      case 5:  // close to a multiple of 0.0001
        return steps * 0.0001 +
               (uniform - 0.5) * std::pow(10.0, -8.0 - static_cast<double>(engine_() % 5));
      default: {
        const double any = std::bit_cast<double>(engine_());
        return std::isnan(any) ? 0.0 : any;
      }
    }
  }

 private:
  std::mt19937_64 engine_{7};
};

TEST(NumberText, FormatsMillionsOfRandomValuesLikePrintf) {
  RandomValues values;
  std::string text;
  for (int i = 0; i < 3000000; ++i) {
    const double value = values.next(i % 7);
    text.clear();
    append_g(value, text);
    ASSERT_EQ(text, printf_g(value)) << std::hexfloat << value;
  }
}

TEST(NumberText, RoundsRandomValuesAsTheirText) {
  RandomValues values;
  std::string text;
  for (int i = 0; i < 3000000; ++i) {
    const double value = i % 2 == 0 ? values.next(i % 7) : -values.next(i % 7);
    if (std::isinf(value)) continue;
    text.clear();
    append_g(value, text);
    const std::optional<double> read = parse_number(text);
    ASSERT_TRUE(read) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(rounded_to_text(value)),
              std::bit_cast<std::uint64_t>(*read))
        << std::hexfloat << value << " " << text;
  }
}

TEST(NumberText, ParsesRandomNumbersLikeStrtod) {
  RandomValues values;

  for (int i = 0; i < 1000000; ++i) {
    const double value = values.next(i % 7);
    if (std::isinf(value)) continue;
    char text[64];
    std::snprintf(text, sizeof text, i % 2 == 0 ? "%g" : "%.17g", value);
    const std::optional<double> read = parse_number(text);
    ASSERT_TRUE(read) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*read),
              std::bit_cast<std::uint64_t>(std::strtod(text, nullptr)))
        << text;
  }
}

TEST(NumberText, ParsesLongAndUnusualNumbers) {
  for (const char* text :
       {"+5", "-.5", "007", "1e2", "1E-2", "1.5e+3", "123456789012345678901234567890",
        "0.000000000000000000000000000000000000000000012345", "9007199254740993",
        "9007199254740992.9999999999999999999", "179769313486231570000000000000000e276", "1e-400",
        "0e999999999999", "1234567890123456789.5", "2.2250738585072011e-308"}) {
    const std::optional<double> read = parse_number(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(*read, std::strtod(text, nullptr)) << text;
  }
}

TEST(NumberText, NeverParsesInfinity) {
  EXPECT_EQ(parse_number("1e999"), std::numeric_limits<double>::max());
  EXPECT_EQ(parse_number("-1e999999999999999999"), -std::numeric_limits<double>::max());
  EXPECT_EQ(parse_number(std::string(5000, '9')), std::numeric_limits<double>::max());
  EXPECT_EQ(parse_number("-1e-999"), 0.0);
  EXPECT_FALSE(parse_number("inf"));
  EXPECT_FALSE(parse_number("nan"));
}

TEST(NumberText, RejectsInvalidNumbers) {
  for (const char* text : {"", "+", "-", ".", "5.", "1e", "1e+", "e5", "0x10", " 5", "5 ", "--5"}) {
    EXPECT_FALSE(parse_number(text)) << text;
  }
  for (const char* text : {"", "+", "1.5", "1e2", "abc", " 5", "5 "}) {
    EXPECT_FALSE(parse_int(text)) << text;
  }
}

TEST(NumberText, RefusesIntegersBeyondTheRange) {
  EXPECT_EQ(parse_int("-2147483648"), std::numeric_limits<int>::min());
  EXPECT_EQ(parse_int("2147483647"), std::numeric_limits<int>::max());

  for (const char* text : {"2147483648", "-2147483649", "99999999999999999999"}) {
    EXPECT_FALSE(parse_int(text)) << text;
  }

  // Clients of the soccer server count on the nearest int.
  int value = 0;
  EXPECT_EQ(parse_int_prefix("99999999999999999999", value), 20u);
  EXPECT_EQ(value, std::numeric_limits<int>::max());
  EXPECT_EQ(parse_int_prefix("-99999999999999999999", value), 21u);
  EXPECT_EQ(value, std::numeric_limits<int>::min());
  EXPECT_EQ(parse_int("+0012"), 12);
}

TEST(NumberText, ShortestTextParsesToSameValue) {
  RandomValues values;

  for (int i = 0; i < 200000; ++i) {
    const double value = values.next(i % 7);
    if (std::isinf(value)) continue;
    std::string text;
    append_shortest(value, text);
    const std::optional<double> read = parse_number(text);
    ASSERT_TRUE(read) << text;
    ASSERT_EQ(*read, value) << text;
  }
}

}  // namespace
}  // namespace cls::base
