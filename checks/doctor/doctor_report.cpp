// Report of `cls doctor` and its JSON document.
#include "checks/doctor/doctor_report.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "base/system/host.h"
#include "base/system/version.h"
#include "base/text/enum_names.h"
#include "base/text/json.h"
#include "base/text/json_text.h"

namespace cls::checks {
namespace {

using base::Json;

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json to_json(const DoctorCheck& check) {
  return {{"name", check.name},
          {"status", name(check.status)},
          {"needed", check.needed},
          {"found", check.found},
          {"version", text_or_null(check.version)},
          {"path", text_or_null(check.path)},
          {"purpose", check.purpose},
          {"remedy", text_or_null(check.hint)}};
}

}  // namespace

std::string_view name(DoctorStatus status) {
  constexpr auto kNames =
      base::enum_names<DoctorStatus>("ok", "missing", "taken", "wrong", "unreachable");
  return kNames.name(status);
}

bool DoctorReport::healthy() const {
  return std::ranges::none_of(checks, [](const DoctorCheck& check) {
    return check.needed && check.status != DoctorStatus::kOk;
  });
}

bool DoctorReport::unreachable() const {
  return std::ranges::any_of(checks, [](const DoctorCheck& check) {
    return check.needed && check.status == DoctorStatus::kUnreachable;
  });
}

std::string to_json(const DoctorReport& report) {
  Json document = {{"schema", "cls.doctor/1"},
                   {"version", base::kVersion},
                   {"wire_version", base::kWireVersion},
                   {"host", base::host_name()},
                   {"time", base::utc_now()},
                   {"healthy", report.healthy()}};
  Json& items = document["items"] = Json::array();
  for (const DoctorCheck& check : report.checks) items.push_back(to_json(check));
  return base::json_document(document);
}

std::string install_command(std::string_view packages) {
  return fmt::format("{}apt-get install {}", ::geteuid() == 0 ? "" : "sudo ", packages);
}

}  // namespace cls::checks
