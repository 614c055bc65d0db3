// Times by strptime and strftime.
#include "tournament/config/start_times.h"

#include <fmt/format.h>

#include <array>

namespace cls::tournament {
namespace {

using base::Error;
using base::Result;

constexpr const char* kLocalForm = "%Y-%m-%d %H:%M";
constexpr const char* kUtcForm = "%Y-%m-%dT%H:%M:%SZ";
constexpr std::size_t kLocalLength = 16;  // "2027-07-15 09:00"

std::string formatted(const std::tm& parts, const char* form) {
  std::array<char, 64> text{};
  return {text.data(), std::strftime(text.data(), text.size(), form, &parts)};
}

Result<StartTime> parse_start_time(const std::string& text) {
  const Error wrong{
      fmt::format("start_times: '{}' must be YYYY-MM-DD HH:MM or STAGE: YYYY-MM-DD HH:MM", text)};
  if (text.size() < kLocalLength) return wrong;

  const std::size_t begin = text.size() - kLocalLength;
  StartTime start;
  if (begin > 0) {
    if (begin < 3 || text.substr(begin - 2, 2) != ": ") return wrong;
    start.stage = text.substr(0, begin - 2);
  }

  std::tm parts{};
  const char* end = ::strptime(text.c_str() + begin, kLocalForm, &parts);
  if (end == nullptr || *end != '\0') return wrong;

  const std::tm read = parts;
  parts.tm_isdst = -1;
  start.time = std::mktime(&parts);
  // mktime turns February 30 into March 2.
  if (start.time == -1 || parts.tm_mday != read.tm_mday) return wrong;
  if (parts.tm_hour != read.tm_hour || parts.tm_min != read.tm_min) {
    return Error{fmt::format("start_times: '{}': clocks skip this time; it would be {}", text,
                             formatted(parts, kLocalForm))};
  }
  return start;
}

}  // namespace

Result<std::vector<StartTime>> parse_start_times(const std::vector<std::string>& texts) {
  std::vector<StartTime> times;
  for (const std::string& text : texts) {
    TRY_INIT(auto time, parse_start_time(text));
    times.push_back(std::move(time));
  }
  return times;
}

std::string local_time_text(std::time_t time) {
  std::tm parts{};
  ::localtime_r(&time, &parts);
  return formatted(parts, kLocalForm);
}

std::string utc_time_text(std::time_t time) {
  std::tm parts{};
  ::gmtime_r(&time, &parts);
  return formatted(parts, kUtcForm);
}

std::time_t parse_utc_time(std::string_view text) {
  std::tm parts{};
  const std::string copy(text);
  const char* end = ::strptime(copy.c_str(), kUtcForm, &parts);
  return end == nullptr || *end != '\0' ? 0 : ::timegm(&parts);
}

}  // namespace cls::tournament
