// Description of one number in an array: name, unit and bounds.
#pragma once

#include <string>
#include <vector>

namespace cls::training {

struct Column {
  std::string name;
  std::string unit;  ///< "m", "deg", "1" for shares and normalized values, "0/1" for flags
  float low = -1.0F;
  float high = 1.0F;
};

using Columns = std::vector<Column>;

}  // namespace cls::training
