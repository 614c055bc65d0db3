// The algorithms and coefficients of SLEEF 3.5.1, functions with an error of at most 1 ulp, without
// fused multiply-add (cinz_*_u10).
#include "soccer/portable_math.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "soccer/double_double.h"
#include "soccer/quarter_turns.h"

namespace cls::soccer::math::portable {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInversePi = 0.318309886183790671537767526745028724;

constexpr DoubleDouble kPiPair = {3.141592653589793116, 1.2246467991473532072e-16};
constexpr DoubleDouble kHalfPiPair = {1.570796326794896557998982, 6.12323399573676603586882e-17};
constexpr DoubleDouble kLog2Pair = {0.693147180559945286226764, 2.319046813846299558417771e-17};

/// Estrin's scheme: the upper terms times a power of x, plus the lower terms, each alike. `powers`:
/// x, x^2, x^4, ...
template <std::size_t kTerms>
double estrin(const double* highest_first, const double* powers) {
  if constexpr (kTerms == 1) {
    return highest_first[0];
  } else {
    constexpr std::size_t kLower = std::bit_ceil(kTerms) / 2;
    constexpr std::size_t kUpper = kTerms - kLower;
    return estrin<kUpper>(highest_first, powers) * powers[std::bit_width(kLower) - 1] +
           estrin<kLower>(highest_first + kUpper, powers);
  }
}

template <std::size_t kTerms>
double polynomial(double x, const double (&highest_first)[kTerms]) {
  const double x2 = x * x;
  const double x4 = x2 * x2;
  const double powers[] = {x, x2, x4, x4 * x4};
  return estrin<kTerms>(highest_first, powers);
}

// One term after the other, from `sum`, that of the highest ones.
template <std::size_t kTerms>
double horner(double sum, double x, const double (&highest_first)[kTerms]) {
  for (const double coefficient : highest_first) sum = sum * x + coefficient;
  return sum;
}

bool is_negative(double x) { return std::signbit(x); }
/// x, negated if y is negative.
double times_sign(double x, double y) { return is_negative(y) ? -x : x; }
double rounded(double x) { return std::rint(x); }
std::int32_t integer(double x) { return static_cast<std::int32_t>(x); }

// 2^exponent for exponents in [-1022, 1023].
double power_of_two(std::int32_t exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}
// In two steps, so that results below the least normal number are rounded once.
double scaled(double x, std::int32_t exponent) {
  const std::int32_t half = exponent >> 1;
  return x * power_of_two(half) * power_of_two(exponent - half);
}

// Reduction of angles.

// Up to here one product with pi is exact enough, up to kMiddleAngles one with four parts of pi.
constexpr double kSmallAngles = 15.0;
constexpr double kMiddleAngles = 1e14;
constexpr double k2To24 = 0x1p24;

constexpr double kPiParts[] = {3.1415926218032836914, 3.1786509424591713469e-08,
                               1.2246467864107188502e-16, 1.2736634327021899816e-24};

// x - count * pi * factor for small counts.
DoubleDouble without_turns(double x, double count, double factor) {
  const double rest = count * (-kPiPair.high * factor) + x;
  return ordered_sum(rest, count * (-kPiPair.low * factor));
}

// The first part was subtracted; (high + low) * pi * factor has four.
DoubleDouble without_other_parts(DoubleDouble rest, double high, double low, double factor) {
  for (std::size_t part = 1; part <= 2; ++part) {
    const double of_pi = -kPiParts[part] * factor;
    rest = sum(sum(rest, high * of_pi), low * of_pi);
  }
  return ordered_sum(rest, (high + low) * (-kPiParts[3] * factor));
}

DoubleDouble without_turns(double x, double high, double low, double factor) {
  const double of_pi = -kPiParts[0] * factor;
  return without_other_parts(ordered_sum(high * of_pi + x, low * of_pi), high, low, factor);
}

struct Reduced {
  DoubleDouble angle;
  std::int32_t count = 0;  ///< of half turns or quarter turns
};

// count: half turns, modulo 2.
Reduced reduced_for_sine(double x) {
  if (std::fabs(x) < kSmallAngles) {
    const double count = rounded(x * kInversePi);
    return {without_turns(x, count, 1.0), integer(count)};
  }
  if (std::fabs(x) < kMiddleAngles) {
    const double high = std::trunc(x * (kInversePi / k2To24)) * k2To24;
    const double low = rounded(x * kInversePi - high);
    return {without_turns(x, high, low, 1.0), integer(low)};
  }

  const auto [rest, quarters] = quarter_turns_of_large(x);
  const bool is_odd = (quarters & 1) != 0;
  const DoubleDouble half_turn = {times_sign(-0.5 * kPiPair.high, rest.high),
                                  times_sign(-0.5 * kPiPair.low, rest.high)};
  const std::int32_t count = ((quarters & 3) * 2 + (rest.high > 0.0 ? 2 : 1)) >> 2;
  return {(is_odd ? sum(rest, half_turn) : rest).normalized(), count};
}

// count: odd numbers of quarter turns.
Reduced reduced_for_cosine(double x) {
  if (std::fabs(x) < kSmallAngles) {
    const double count = 2.0 * rounded(x * kInversePi + -0.5) + 1.0;
    const DoubleDouble rest = sum(x, count * (-kPiPair.high * 0.5));
    return {ordered_sum(rest, count * (-kPiPair.low * 0.5)), integer(count)};
  }
  if (std::fabs(x) < kMiddleAngles) {
    const double turns = std::trunc(x * (kInversePi / 0x1p23) + -kInversePi / k2To24);
    const double half_turns = rounded(x * kInversePi + (turns * -0x1p23 + -0.5));
    const double high = turns * k2To24;
    const double low = 2.0 * half_turns + 1.0;
    const double of_pi = -kPiParts[0] * 0.5;
    const DoubleDouble rest = sum(high * of_pi + x, low * of_pi);
    return {without_other_parts(rest, high, low, 0.5), integer(low)};
  }

  const auto [rest, quarters] = quarter_turns_of_large(x);
  const bool is_even = (quarters & 1) == 0;
  const double sign = rest.high > 0.0 ? 0.0 : -1.0;
  const DoubleDouble half_turn = {times_sign(-0.5 * kPiPair.high, sign),
                                  times_sign(-0.5 * kPiPair.low, sign)};
  const std::int32_t count = ((quarters & 3) * 2 + (rest.high > 0.0 ? 8 : 7)) >> 1;
  return {(is_even ? sum(rest, half_turn) : rest).normalized(), count};
}

// count: quarter turns.
Reduced reduced_for_both(double x) {
  if (std::fabs(x) < kSmallAngles) {
    const double count = rounded(x * (2.0 * kInversePi));
    return {without_turns(x, count, 0.5), integer(count)};
  }
  if (std::fabs(x) < kMiddleAngles) {
    const double high = std::trunc(x * (2.0 * kInversePi / k2To24)) * k2To24;
    const double low = rounded(x * (2.0 * kInversePi) - high);
    return {without_turns(x, high, low, 0.5), integer(low)};
  }
  const auto [rest, quarters] = quarter_turns_of_large(x);
  return {rest, quarters};
}

Reduced reduced_for_tangent(double x) {
  if (std::fabs(x) < kSmallAngles || !(std::fabs(x) < kMiddleAngles)) return reduced_for_both(x);
  constexpr DoubleDouble kInverseHalfPi = {0.63661977236758138243, -3.9357353350364971764e-17};
  const double high = std::trunc(x * (2.0 * kInversePi / k2To24)) * k2To24;
  const double to_nearest = (x < 0.0 ? -0.5 : 0.5) - high;
  const double low = std::trunc(sum(product(kInverseHalfPi, x), to_nearest).rounded());
  return {without_turns(x, high, low, 0.5), integer(low)};
}

// Sine of an angle in [-pi/2, pi/2].
double sine_of(DoubleDouble angle) {
  const DoubleDouble squared = square(angle);
  double sum =
      polynomial(squared.high, {2.72052416138529567917983e-15, -7.6429259411395447190023e-13,
                                1.60589370117277896211623e-10, -2.5052106814843123359368e-08,
                                2.75573192104428224777379e-06, -0.000198412698412046454654947});
  sum = sum * squared.high + 0.00833333333333318056201922;

  const DoubleDouble third = ordered_sum(-0.166666666666666657414808, sum * squared.high);
  return rounded_product(angle, ordered_sum(1.0, product(third, squared)));
}

// Angles and ratios.

// atan2 of y >= 0 and x.
DoubleDouble arc_tangent(double y, double x) {
  int quarters = is_negative(x) ? -2 : 0;
  if (x < 0.0) x = -x;
  DoubleDouble numerator = {y, 0.0};
  DoubleDouble denominator = {x, 0.0};
  if (x < y) {
    ++quarters;
    numerator = -DoubleDouble{x, 0.0};
    denominator = {y, 0.0};
  }

  const DoubleDouble ratio = quotient(numerator, denominator);
  const DoubleDouble squared = square(ratio).normalized();
  double sum = polynomial(
      squared.high,
      {1.06298484191448746607415e-05, -0.000125620649967286867384336, 0.00070557664296393412389774,
       -0.00251865614498713360352999, 0.00646262899036991172313504, -0.0128281333663399031014274,
       0.0208024799924145797902497, -0.0289002344784740315686289, 0.0359785005035104590853656,
       -0.041848579703592507506027, 0.0470843011653283988193763, -0.0524914210588448421068719,
       0.0587946590969581003860434, -0.0666620884778795497194182, 0.0769225330296203768654095,
       -0.0909090442773387574781907});
  sum = horner(sum, squared.high,
               {0.111111108376896236538123, -0.142857142756268568062339, 0.199999999997977351284817,
                -0.333333333333317605173818});

  const DoubleDouble angle = ordered_sum(ratio, product(product(ratio, squared), sum));
  return ordered_sum(product(kHalfPiPair, quarters), angle);
}

// Of asin and acos: the series for |x| below a half, and beyond it that of the root of (1 - |x|)
// / 2.
struct ArcSineSeries {
  explicit ArcSineSeries(double x) : is_small(std::fabs(x) < 0.5) {
    const double squared = is_small ? x * x : (1.0 - std::fabs(x)) * 0.5;
    if (std::fabs(x) != 1.0) {
      first = is_small ? DoubleDouble{std::fabs(x), 0.0} : square_root(squared);
    }
    const double sum = polynomial(
        squared, {+0.3161587650653934628e-1, -0.1581918243329996643e-1, +0.1929045477267910674e-1,
                  +0.6606077476277170610e-2, +0.1215360525577377331e-1, +0.1388715184501609218e-1,
                  +0.1735956991223614604e-1, +0.2237176181932048341e-1, +0.3038195928038132237e-1,
                  +0.4464285681377102438e-1, +0.7500000000378581611e-1, +0.1666666666666497543e+0});
    others = sum * (squared * first.high);
  }

  bool is_small;
  DoubleDouble first;
  double others = 0.0;
};

// Powers and logarithms.

// x = significand * 2^exponent, with a significand in about [0.75, 1.5).
struct Scaled {
  explicit Scaled(double x) {
    const bool is_subnormal = x < std::numeric_limits<double>::min();
    if (is_subnormal) x *= 0x1p64;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x * (1.0 / 0.75));
    exponent = static_cast<std::int32_t>(bits >> 52 & 0x7ff) - 1023;
    significand = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) -
                                        (static_cast<std::uint64_t>(exponent) << 52));
    if (is_subnormal) exponent -= 64;
  }

  double significand;
  std::int32_t exponent;
};

// (m - 1) / (m + 1), whose odd powers are the series of log(m).
DoubleDouble log_ratio(double m) { return quotient(sum(-1.0, m), sum(1.0, m)); }

DoubleDouble log_pair(double x) {
  const Scaled scaled(x);
  const DoubleDouble ratio = log_ratio(scaled.significand);
  const DoubleDouble squared = square(ratio);
  const double sum = polynomial(
      squared.high,
      {0.116255524079935043668677, 0.103239680901072952701192, 0.117754809412463995466069,
       0.13332981086846273921509, 0.153846227114512262845736, 0.181818180850050775676507,
       0.222222222230083560345903, 0.285714285714249172087875, 0.400000000000000077715612});

  constexpr DoubleDouble kTwoThirds = {0.666666666666666629659233, 3.80554962542412056336616e-17};
  DoubleDouble log = product(kLog2Pair, scaled.exponent);
  log = ordered_sum(log, ratio.scaled(2.0));
  DoubleDouble power = product(squared, ratio);
  log = ordered_sum(log, product(power, kTwoThirds));
  power = product(squared, power);
  return ordered_sum(log, product(power, sum));
}

constexpr double kInverseLog2 =
    1.442695040888963407359924681001892137426645954152985934135449406931;
constexpr double kLog2High = .69314718055966295651160180568695068359375;
constexpr double kLog2Low = .28235290563031577122588448175013436025525412068e-12;
constexpr double kMaxExponent = 709.78271114955742909217217426;
constexpr double kMinExponent = -1000.0;

double exp_of_pair(DoubleDouble x) {
  if (x.high > kMaxExponent) return kInfinity;
  if (x.high < kMinExponent) return 0.0;
  const double whole = rounded(x.rounded() * kInverseLog2);
  if (std::isnan(whole)) return kNaN;
  DoubleDouble rest = sum(x, whole * -kLog2High);
  rest = sum(rest, whole * -kLog2Low).normalized();

  const double series =
      polynomial(rest.high, {2.51069683420950419527139e-08, 2.76286166770270649116855e-07,
                             2.75572496725023574143864e-06, 2.48014973989819794114153e-05,
                             0.000198412698809069797676111, 0.0013888888939977128960529,
                             0.00833333333332371417601081, 0.0416666666665409524128449,
                             0.166666666666666740681535, 0.500000000000000999200722});
  DoubleDouble power = ordered_sum(1.0, rest);
  power = ordered_sum(power, product(square(rest), series));
  return scaled(power.rounded(), integer(whole));
}

}  // namespace

double sin(double x) {
  if (x == 0.0 || !std::isfinite(x)) return x == 0.0 ? x : kNaN;
  const Reduced reduced = reduced_for_sine(x);
  const double sine = sine_of(reduced.angle);
  return (reduced.count & 1) != 0 ? -sine : sine;
}

double cos(double x) {
  if (!std::isfinite(x)) return kNaN;
  const Reduced reduced = reduced_for_cosine(x);
  const double sine = sine_of(reduced.angle);
  return (reduced.count & 2) == 0 ? -sine : sine;
}

SinCos sincos(double x) {
  if (!std::isfinite(x)) return {kNaN, kNaN};
  const auto [angle, quarters] = reduced_for_both(x);
  const double squared = rounded_square(angle);

  double series = horner(
      1.58938307283228937328511e-10, squared,
      {-2.50506943502539773349318e-08, 2.75573131776846360512547e-06,
       -0.000198412698278911770864914, 0.0083333333333191845961746, -0.166666666666666130709393});
  double sine = ordered_sum(angle, series * (squared * angle.high)).rounded();
  if (x == 0.0) sine = x;

  series = horner(
      -1.13615350239097429531523e-11, squared,
      {2.08757471207040055479366e-09, -2.75573144028847567498567e-07, 2.48015872890001867311915e-05,
       -0.00138888888888714019282329, 0.0416666666666665519592062, -0.5});
  const double cosine = ordered_sum(1.0, product(squared, series)).rounded();

  const bool swapped = (quarters & 1) != 0;
  const double first = swapped ? cosine : sine;
  const double second = swapped ? sine : cosine;
  return {(quarters & 2) != 0 ? -first : first, ((quarters + 1) & 2) != 0 ? -second : second};
}

double tan(double x) {
  if (x == 0.0 || !std::isfinite(x)) return x == 0.0 ? x : kNaN;
  const auto [angle, quarters] = reduced_for_tangent(x);
  const DoubleDouble half = angle.scaled(0.5);
  const DoubleDouble squared = square(half);
  double series = polynomial(squared.high, {+0.3245098826639276316e-3, +0.5619219738114323735e-3,
                                            +0.1460781502402784494e-2, +0.3591611540792499519e-2,
                                            +0.8863268409563113126e-2, +0.2186948728185535498e-1,
                                            +0.5396825399517272970e-1, +0.1333333333330500581e+0});
  series = series * squared.high + 0.3333333333333343695e+0;
  const DoubleDouble tangent = ordered_sum(half, product(product(squared, half), series));

  // tan(2a) = 2 tan(a) / (1 - tan(a)^2); a quarter turn on it is the negative inverse.
  const DoubleDouble below = ordered_sum(-1.0, square(tangent));
  const DoubleDouble above = tangent.scaled(-2.0);
  const bool inverse = (quarters & 1) != 0;
  return quotient(inverse ? -below : above, inverse ? above : below).rounded();
}

double asin(double x) {
  const ArcSineSeries series(x);
  constexpr DoubleDouble kQuarterPi = {kPiPair.high / 4, kPiPair.low / 4};
  const DoubleDouble rest =
      ordered_difference(ordered_difference(kQuarterPi, series.first), series.others);
  return times_sign(series.is_small ? series.others + series.first.high : rest.rounded() * 2.0, x);
}

double acos(double x) {
  const ArcSineSeries series(x);
  if (series.is_small) {
    const DoubleDouble arc_sine =
        ordered_sum(times_sign(series.first.high, x), times_sign(series.others, x));
    constexpr DoubleDouble kHalfPi = {kPiPair.high / 2, kPiPair.low / 2};
    return ordered_difference(kHalfPi, arc_sine).rounded();
  }
  const DoubleDouble angle = ordered_sum(series.first, series.others).scaled(2.0);
  return (x < 0.0 ? ordered_difference(kPiPair, angle) : angle).rounded();
}

double atan(double x) {
  if (std::isnan(x)) return kNaN;
  const double angle = std::isinf(x) ? kHalfPiPair.high : arc_tangent(std::fabs(x), 1.0).rounded();
  return times_sign(angle, x);
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return kNaN;
  // The inverse of a smaller number is infinite.
  constexpr double kSmallest = 5.5626846462680083984e-309;
  if (std::fabs(x) < kSmallest) {
    x *= 0x1p53;
    y *= 0x1p53;
  }

  constexpr double kHalf = kPi / 2;
  if (y == 0.0) return times_sign(is_negative(x) ? kPi : 0.0, y);
  if (std::isinf(y)) {
    return times_sign(kHalf - (std::isinf(x) ? times_sign(kHalf / 2, x) : 0.0), y);
  }
  if (x == 0.0) return times_sign(kHalf, y);
  if (std::isinf(x)) return times_sign(kHalf - times_sign(kHalf, x), y);

  const double angle = arc_tangent(std::fabs(y), x).rounded();
  return times_sign(times_sign(angle, x), y);
}

double exp(double x) {
  if (std::isnan(x)) return kNaN;
  if (x > kMaxExponent) return kInfinity;
  if (x < kMinExponent) return 0.0;
  const double whole = rounded(x * kInverseLog2);
  double rest = whole * -kLog2High + x;
  rest = whole * -kLog2Low + rest;

  double series = polynomial(rest, {2.08860621107283687536341e-09, 2.51112930892876518610661e-08,
                                    2.75573911234900471893338e-07, 2.75572362911928827629423e-06,
                                    2.4801587159235472998791e-05, 0.000198412698960509205564975,
                                    0.00138888888889774492207962, 0.00833333333331652721664984,
                                    0.0416666666666665047591422, 0.166666666666666851703837});
  series = series * rest + 0.5;
  return scaled(1.0 + (rest * rest * series + rest), integer(whole));
}

double log(double x) {
  if (std::isnan(x) || x < 0.0) return kNaN;
  if (x == 0.0) return -kInfinity;
  if (std::isinf(x)) return kInfinity;
  const Scaled scaled(x);
  const DoubleDouble ratio = log_ratio(scaled.significand);
  const double squared = ratio.high * ratio.high;
  const double series = polynomial(
      squared, {0.1532076988502701353e+0, 0.1525629051003428716e+0, 0.1818605932937785996e+0,
                0.2222214519839380009e+0, 0.2857142932794299317e+0, 0.3999999999635251990e+0,
                0.6666666666667333541e+0});

  DoubleDouble log = product(kLog2Pair, scaled.exponent);
  log = ordered_sum(log, ratio.scaled(2.0));
  return ordered_sum(log, squared * ratio.high * series).rounded();
}

double pow(double x, double y) {
  if (y == 0.0 || x == 1.0) return 1.0;
  if (std::isnan(x) || std::isnan(y)) return kNaN;
  const bool is_whole = std::trunc(y) == y || std::isinf(y);
  const bool is_odd = is_whole && std::fabs(y) < 0x1p53 && (static_cast<std::int64_t>(y) & 1) != 0;
  if (std::isinf(x) || x == 0.0) {
    const bool grows = !((x == 0.0 ? -y : y) < 0.0);
    return (is_odd ? times_sign(1.0, x) : 1.0) * (grows ? kInfinity : 0.0);
  }
  if (std::isinf(y)) {
    const double growth = times_sign(std::fabs(x) - 1.0, y);
    return growth < 0.0 ? 0.0 : growth == 0.0 ? 1.0 : kInfinity;
  }

  const double power = exp_of_pair(product(log_pair(std::fabs(x)), y));
  if (x > 0.0) return power;
  if (!is_whole) return kNaN;
  return is_odd ? -power : power;
}

}  // namespace cls::soccer::math::portable
