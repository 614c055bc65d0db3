// The functions of portable_math.h against those of SLEEF, bit for bit.
#include "soccer/portable_math.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "base/text/fnv1a.h"
#include "soccer/math.h"
#include "soccer/math_library.h"

namespace cls::soccer::math {
namespace {

struct Function {
  const char* name;
  double (*theirs)(double, double);
  double (*ours)(double, double);
};

/// Functions of one argument ignore the second.
constexpr std::array kFunctions = {
    Function{"sin", [](double x, double) { return sin(x); },
             [](double x, double) { return portable::sin(x); }},
    Function{"cos", [](double x, double) { return cos(x); },
             [](double x, double) { return portable::cos(x); }},
    Function{"tan", [](double x, double) { return tan(x); },
             [](double x, double) { return portable::tan(x); }},
    Function{"asin", [](double x, double) { return asin(x); },
             [](double x, double) { return portable::asin(x); }},
    Function{"acos", [](double x, double) { return acos(x); },
             [](double x, double) { return portable::acos(x); }},
    Function{"atan", [](double x, double) { return atan(x); },
             [](double x, double) { return portable::atan(x); }},
    Function{"atan2", [](double x, double y) { return atan2(x, y); },
             [](double x, double y) { return portable::atan2(x, y); }},
    Function{"exp", [](double x, double) { return exp(x); },
             [](double x, double) { return portable::exp(x); }},
    Function{"log", [](double x, double) { return log(x); },
             [](double x, double) { return portable::log(x); }},
    Function{"pow", [](double x, double y) { return pow(x, y); },
             [](double x, double y) { return portable::pow(x, y); }},
    Function{"sincos, sine", [](double x, double) { return sincos(x).sin; },
             [](double x, double) { return portable::sincos(x).sin; }},
    Function{"sincos, cosine", [](double x, double) { return sincos(x).cos; },
             [](double x, double) { return portable::sincos(x).cos; }},
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Where functions change their branch, and the values that IEEE names.
constexpr double kSpecial[] = {
    0.0,     0.5,    1.0,     2.0,      3.0,    15.0,   1e14,     1e15,      1e300,
    0x1p52,  0x1p53, 0x1p-53, 0x1p-27,  1e-308, 1e-309, 5e-324,   0x1p1023,  1.5707963267948966,
    709.782, 709.79, 745.13,  1000.001, 708.39, 22.0,   0x1.8p52, kInfinity, 3.141592653589793,
};

/// Arguments of all magnitudes, most of them of those in matches. The generator is specified by the
/// standard, its distributions are not.
class Arguments {
 public:
  double next() {
    switch (bits_() % 8) {
      case 0:
        return std::bit_cast<double>(bits_());
      case 1:
        return signed_value(200.0);
      case 2:
        return any_magnitude();
      case 3:
        return special();
      case 4:
        return std::nearbyint(signed_value(30.0));
      case 5:
        return signed_value(1.0);
      default:
        return signed_value(4.0);
    }
  }

 private:
  double signed_value(double limit) {
    return (static_cast<double>(bits_() >> 11) * 0x1p-52 - 1.0) * limit;
  }

  double any_magnitude() {
    const int exponent = static_cast<int>(bits_() % 140) - 70;
    return std::ldexp(signed_value(1.0), exponent);
  }

  // A special value or one of its neighbors, of either sign.
  double special() {
    const double value = kSpecial[bits_() % std::size(kSpecial)];
    const double toward[] = {0.0, value, kInfinity};
    const double near = std::nextafter(value, toward[bits_() % 3]);
    return bits_() % 2 == 0 ? near : -near;
  }

  std::mt19937_64 bits_{7};
};

/// One number for all NaNs.
std::uint64_t bits_of(double value) {
  return std::isnan(value) ? 0x7ff8'0000'0000'0000u : std::bit_cast<std::uint64_t>(value);
}

// 10^8 arguments each with CLS_FULL=1 (`make full`).
TEST(PortableMath, HasTheBitsOfSleef) {
#ifndef CLS_SLEEF
  GTEST_SKIP() << "this build has no SLEEF";
#endif
  const int count = std::getenv("CLS_FULL") != nullptr ? 100'000'000 : 200'000;

  for (const Function& function : kFunctions) {
    Arguments arguments;
    int differences = 0;
    for (int i = 0; i < count && differences < 3; ++i) {
      const double x = arguments.next();
      const double y = arguments.next();
      const double expected = function.theirs(x, y);
      const double actual = function.ours(x, y);
      if (bits_of(actual) == bits_of(expected)) continue;

      ++differences;
      ADD_FAILURE() << std::hexfloat << function.name << " of " << x << ", " << y << ": " << actual
                    << " instead of " << expected;
    }
  }
}

// Also where SLEEF is missing: hashes of the results that SLEEF gave on x86-64.
TEST(PortableMath, HasTheseBits) {
  constexpr std::uint64_t kHashes[kFunctions.size()] = {
      0x5763f9aa7354421d, 0xf77fed4012cdcbcb, 0x59989621eb66c4bf, 0xf14d3711db12cf54,
      0xa3a7fbffca13a1ef, 0xddb23a91c2f287b3, 0xa9322c984cf0ad6a, 0xb8bd89e466fff77a,
      0x80fae096dd272148, 0x20fc5c108b51034d, 0x35c2084faf1a2b77, 0xe1df79fb006a1344,
  };

  for (std::size_t i = 0; i < kFunctions.size(); ++i) {
    Arguments arguments;
    std::string bytes;
    for (int count = 0; count < 20'000; ++count) {
      const double x = arguments.next();
      const std::uint64_t bits = bits_of(kFunctions[i].ours(x, arguments.next()));
      for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(bits >> shift & 0xff);
    }
    EXPECT_EQ(base::fnv1a(bytes), kHashes[i]) << kFunctions[i].name;
  }
}

}  // namespace
}  // namespace cls::soccer::math
