// Finds the first difference of two records.
#include "tests/viewer/record_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "base/io/byte_sink.h"
#include "gamelog/rcg/rcg_writer.h"
#include "soccer/messages/parameter_message.h"

namespace cls::tests {
namespace {

using namespace cls::gamelog;

template <typename T>
std::string column(const char* name, const Column<T>& a, const Column<T>& b, std::size_t series) {
  if (a.size() != b.size()) return fmt::format("size of {}", name);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::memcmp(&a[i], &b[i], sizeof(T)) == 0) continue;
    return fmt::format("{} of frame {}, slot {}", name, i / series, i % series);
  }
  return "";
}

std::string columns(const MatchRecord& a, const MatchRecord& b) {
  const PlayerColumns& p = a.players;
  const PlayerColumns& q = b.players;
  const std::string differences[] = {
      column("time", a.time, b.time, 1),
      column("stopped", a.stopped, b.stopped, 1),
      column("mode", a.mode, b.mode, 1),
      column("team_state", a.team_state, b.team_state, 1),
      column("ball_position", a.ball_position, b.ball_position, 1),
      column("ball_velocity", a.ball_velocity, b.ball_velocity, 1),
      column("ball_height", a.ball_height, b.ball_height, 1),
      column("state", p.state, q.state, kSlots),
      column("type", p.type, q.type, kSlots),
      column("position", p.position, q.position, kSlots),
      column("velocity", p.velocity, q.velocity, kSlots),
      column("body", p.body, q.body, kSlots),
      column("neck", p.neck, q.neck, kSlots),
      column("pointing_at", p.pointing_at, q.pointing_at, kSlots),
      column("view_width", p.view_width, q.view_width, kSlots),
      column("high_quality", p.high_quality, q.high_quality, kSlots),
      column("focus", p.focus, q.focus, kSlots),
      column("stamina", p.stamina, q.stamina, kSlots),
      column("effort", p.effort, q.effort, kSlots),
      column("recovery", p.recovery, q.recovery, kSlots),
      column("capacity", p.capacity, q.capacity, kSlots),
      column("attention", p.attention, q.attention, kSlots),
      column("counters", p.counters, q.counters, kSlots),
  };
  const auto found = std::find_if(std::begin(differences), std::end(differences),
                                  [](const std::string& text) { return !text.empty(); });
  return found == std::end(differences) ? "" : *found;
}

bool same_content(const Note& a, const Note& b) {
  if (a.content.index() != b.content.index()) return false;
  if (const auto* line = std::get_if<UnknownLine>(&a.content)) {
    return line->text == std::get<UnknownLine>(b.content).text;
  }
  if (const auto* message = std::get_if<Message>(&a.content)) {
    return *message == std::get<Message>(b.content);
  }
  if (const auto* teams = std::get_if<TeamFrames>(&a.content)) {
    return *teams == std::get<TeamFrames>(b.content);
  }
  return std::get<soccer::PlayMode>(a.content) == std::get<soccer::PlayMode>(b.content);
}

bool same_note(const Note& a, const Note& b) {
  return a.frame == b.frame && a.time == b.time && a.stopped == b.stopped && same_content(a, b);
}

bool same_errors(const ParseErrors& a, const ParseErrors& b) {
  const auto same = [](const ParseError& left, const ParseError& right) {
    return left.line == right.line && left.byte == right.byte && left.cycle == right.cycle &&
           left.message == right.message;
  };
  return a.count == b.count &&
         std::equal(a.first.begin(), a.first.end(), b.first.begin(), b.first.end(), same);
}

template <typename Params>
std::string text_of(const Params& params) {
  std::string text;
  soccer::format(params, soccer::kAllVersions, text);
  return text;
}

std::string types_of(const MatchRecord& record) {
  std::string text;
  for (const soccer::PlayerType& type : record.types) text += text_of(type) + "\n";
  return text;
}

}  // namespace

std::string record_difference(const MatchRecord& a, const MatchRecord& b) {
  if (a.version != b.version) return "version";
  if (a.server_version != b.server_version) return "server_version";
  if (a.timestamp != b.timestamp) return "timestamp";
  if (a.has_ball_height != b.has_ball_height) return "has_ball_height";
  if (a.parameter_lines != b.parameter_lines) return "parameter_lines";
  if (text_of(a.server) != text_of(b.server)) return "server";
  if (text_of(a.player) != text_of(b.player)) return "player";
  if (types_of(a) != types_of(b)) return "types";
  if (a.teams != b.teams) return "teams";
  if (!std::equal(a.notes.begin(), a.notes.end(), b.notes.begin(), b.notes.end(), same_note)) {
    return "notes";
  }
  if (!same_errors(a.errors, b.errors)) return "errors";
  return columns(a, b);
}

}  // namespace cls::tests
