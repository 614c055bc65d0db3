// Finds the first difference of two records.
#include "tests/viewer/record_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <tuple>

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

  const auto found = std::ranges::find_if_not(differences, &std::string::empty);
  return found == std::end(differences) ? "" : *found;
}

// Equal notes give equal keys.
auto key_of(const Note& note) {
  const auto* line = std::get_if<UnknownLine>(&note.content);
  const auto* message = std::get_if<Message>(&note.content);
  const auto* teams = std::get_if<TeamFrames>(&note.content);
  const auto* mode = std::get_if<soccer::PlayMode>(&note.content);
  return std::tuple(note.frame, note.time, note.stopped, line ? line->text : "",
                    message ? *message : Message(), teams ? *teams : TeamFrames(),
                    mode ? std::optional(*mode) : std::nullopt, note.content.index());
}

auto key_of_error(const ParseError& error) {
  return std::tuple(error.line, error.byte, error.cycle, error.message);
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
  if (!std::ranges::equal(a.notes, b.notes, {}, key_of, key_of)) return "notes";
  if (a.errors.count != b.errors.count) return "number of errors";
  if (!std::ranges::equal(a.errors.first, b.errors.first, {}, key_of_error, key_of_error)) {
    return "errors";
  }
  return columns(a, b);
}

std::string record_difference(const MatchRecord& a, const base::Result<viewer::StreamMatch>& b) {
  return b ? record_difference(a, b->record) : b.error().message;
}

}  // namespace cls::tests
