// An estimate with its confidence interval.
#pragma once

namespace cls::review {

/// With its 95 % interval, in the unit of the value.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

}  // namespace cls::review
