// Verdict and JSON document.
#include "orchestration/checks/doctor/diagnosis.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/system/host.h"
#include "base/system/version.h"

namespace cls::orchestration::checks {
namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json to_json(const Symptom& symptom) {
  return {{"name", symptom.name},
          {"status", name(symptom.health)},
          {"needed", symptom.needed},
          {"found", symptom.found},
          {"version", text_or_null(symptom.version)},
          {"path", text_or_null(symptom.path)},
          {"purpose", symptom.purpose},
          {"remedy", text_or_null(symptom.remedy)}};
}

}  // namespace

std::string_view name(Health health) {
  switch (health) {
    case Health::kMissing:
      return "missing";
    case Health::kTaken:
      return "taken";
    case Health::kWrong:
      return "wrong";
    case Health::kUnreachable:
      return "unreachable";
    case Health::kOk:
      break;
  }
  return "ok";
}

bool Diagnosis::healthy() const {
  return std::none_of(symptoms.begin(), symptoms.end(), [](const Symptom& symptom) {
    return symptom.needed && symptom.health != Health::kOk;
  });
}

bool Diagnosis::unreachable() const {
  return std::any_of(symptoms.begin(), symptoms.end(), [](const Symptom& symptom) {
    return symptom.needed && symptom.health == Health::kUnreachable;
  });
}

std::string to_json(const Diagnosis& diagnosis) {
  Json document = {{"schema", "cls.doctor/1"},
                   {"version", base::kVersion},
                   {"wire_version", base::kWireVersion},
                   {"host", base::host_name()},
                   {"time", base::utc_now()},
                   {"healthy", diagnosis.healthy()}};
  Json& items = document["items"] = Json::array();
  for (const Symptom& symptom : diagnosis.symptoms) items.push_back(to_json(symptom));
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string install_command(std::string_view packages) {
  return fmt::format("{}apt-get install {}", ::geteuid() == 0 ? "" : "sudo ", packages);
}

}  // namespace cls::orchestration::checks
