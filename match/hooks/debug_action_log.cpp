// Conversion of debug actions to JSON.
#include "match/hooks/debug_action_log.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>

#include "base/text/json.h"
#include "base/text/json_text.h"
#include "proto/playmaker.pb.h"
#include "proxy/agent/player_agent.h"
#include "viewer/decisions/decision_files.h"

namespace cls::match {
namespace {

using base::Json;

// The fields of a message under their names in the .proto file.
Json fields_of(const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  std::string text;
  const auto status = google::protobuf::util::MessageToJsonString(message, &text, options);
  return status.ok() ? Json::parse(text) : Json::object();
}

// "add_circle" is a "circle".
std::string kind_of(const protos::Log& log) {
  const auto* field = protos::Log::descriptor()->FindFieldByNumber(log.log_case());
  return field == nullptr ? "nothing" : field->name().substr(4);
}

Json json_of(player::GameTime now, int unum, const protos::PlayerAction& action) {
  Json json = {{"t", now.cycle}};
  if (now.stopped > 0) json["stopped"] = now.stopped;
  json["unum"] = unum;
  if (action.has_debug_client()) {
    json["kind"] = "debug_client";
    json["message"] = action.debug_client().message();
    return json;
  }
  const protos::Log& log = action.log();
  json["kind"] = kind_of(log);
  const Json all = fields_of(log);
  for (const auto& [unused, shape] : all.items()) {
    for (const auto& [key, value] : shape.items()) json[key] = value;
  }
  return json;
}

}  // namespace

DebugActionLog::DebugActionLog(const std::filesystem::path& folder)
    : SideHooks({DebugActionsOfSide(folder / viewer::kLeftDebugFile),
                 DebugActionsOfSide(folder / viewer::kRightDebugFile)}) {}

void DebugActionsOfSide::on_decision(const proxy::Decision& decision) {
  if (decision.reply == nullptr) return;

  const player::GameTime now = decision.agent.world().game.time;
  const int unum = decision.agent.unum();
  for (const auto& action : decision.reply->actions()) {
    if (!action.has_log() && !action.has_debug_client()) continue;
    if (room_ == 0) {
      ++omitted_;
      continue;
    }
    // The text of a Playmaker may not be UTF-8.
    lines_.emplace_back(unum, base::json_line(json_of(now, unum, action)));
  }
}

void DebugActionsOfSide::write(std::string_view line) {
  if (line.size() >= room_) room_ = 0;
  if (room_ == 0) {
    ++omitted_;
    return;
  }
  sink_->write(line);
  sink_->write("\n");
  room_ -= line.size() + 1;
}

void DebugActionsOfSide::end_cycle() {
  if (lines_.empty() || !error_.empty()) return;
  if (sink_ == nullptr) {
    auto created = base::FileSink::create(file_.string());
    if (!created) {
      error_ = created.error().message;
      return;
    }
    sink_ = *std::move(created);
  }

  std::ranges::stable_sort(lines_, {}, &std::pair<int, std::string>::first);
  for (const auto& [unused, line] : lines_) write(line);
  lines_.clear();
  sink_->flush();
}

std::string DebugActionsOfSide::close() {
  end_cycle();
  if (sink_ != nullptr && omitted_ > 0) {
    const Json last = {{"kind", "omitted"}, {"count", omitted_}};
    sink_->write(base::json_line(last) + "\n");
  }
  if (sink_ != nullptr && error_.empty()) {
    const auto closed = sink_->close();
    if (!closed) error_ = closed.error().message;
  }
  return error_;
}

}  // namespace cls::match
