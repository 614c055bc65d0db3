// Reading the end reason out of a `result.json`.
#include "analysis/results/match_document.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

namespace cls::analysis {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::uintmax_t kLargestDocument = 16 << 20;
constexpr const char* kFinished = "finished";

// Null if there is no such document.
Json document_in(const fs::path& folder) {
  const fs::path path = folder / "result.json";
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error || size > kLargestDocument) return nullptr;
  std::ifstream file(path, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  Json document = Json::parse(text, nullptr, false);
  const bool known = document.is_object() && document.value("schema", Json()) == "cls.match/1";
  return known ? document : Json(nullptr);
}

bool names_log(const Json& document, const std::string& name) {
  const Json files = document.value("log_files", Json::object());
  return files.is_object() &&
         (files.value("rcg", Json()) == name || files.value("rcl", Json()) == name);
}

}  // namespace

void add_end_reason(const std::string& log, MatchSummary& summary) {
  const fs::path path(log);
  const Json document = document_in(path.parent_path());
  if (!document.is_object() || !names_log(document, path.filename().string())) return;
  const Json reason = document.value("end_reason", Json());
  if (!reason.is_string()) return;
  summary.end_reason = reason.get<std::string>();
  const bool finished = summary.end_reason == kFinished;
  if (finished == summary.complete) return;
  summary.complete = finished;
  decide_winner(summary, Winner::kNone);
}

}  // namespace cls::analysis
