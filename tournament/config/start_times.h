// The key start_times: when a tournament and its stages begin.
#pragma once

#include <ctime>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::tournament {

/// "2027-07-15 09:00", or "final day: 2027-07-18 10:00", in the time of this host.
struct StartTime {
  std::string stage;  ///< the begin of the stage of a fixture; empty: the tournament
  std::time_t time = 0;
};

/// Parses the values of the key. The error quotes the wrong one.
base::Result<std::vector<StartTime>> parse_start_times(const std::vector<std::string>& texts);

/// "2027-07-15 09:00", in the time of this host.
std::string local_time_text(std::time_t time);

/// "2027-07-15T07:00:00Z".
std::string utc_time_text(std::time_t time);

/// The time of such a text; 0 for another text.
std::time_t parse_utc_time(std::string_view text);

}  // namespace cls::tournament
