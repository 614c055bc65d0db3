// Numbers, points and players as all statistics write them in JSON.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/play/flow.h"
#include "soccer/side_name.h"

namespace cls::analysis {

using Json = nlohmann::ordered_json;

// Four decimals: what the log holds.
inline double rounded(double value) { return std::round(value * 1e4) / 1e4 + 0.0; }

inline double share(int part, int whole) { return whole == 0 ? 0.0 : rounded(1.0 * part / whole); }

inline Json point_json(soccer::Vec2 p) { return Json::array({rounded(p.x), rounded(p.y)}); }

inline const char* side_word(std::size_t slot) {
  return side_name(soccer::side_of_slot(static_cast<int>(slot)));
}

inline int unum_of(std::size_t slot) { return soccer::unum_of_slot(static_cast<int>(slot)); }

inline Json unum_or_null(std::int8_t slot) {
  return slot == kNobody ? Json(nullptr) : Json(unum_of(static_cast<std::size_t>(slot)));
}

}  // namespace cls::analysis
