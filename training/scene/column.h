// Description of one number in an array: name, unit and bounds.
#pragma once

#include <initializer_list>
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

/// Appends columns of one unit and range, whose names begin with `who`.
inline void append(Columns& out, const std::string& who, std::initializer_list<const char*> names,
                   const char* unit = "1", float low = -1.0F, float high = 1.0F) {
  for (const char* name : names) out.push_back({who + name, unit, low, high});
}

}  // namespace cls::training
