// Keeping the notes.
#include "proxy/coach/coach_notes.h"

namespace cls::proxy {
namespace {

// Types on the field at the kick-off count as used.
void count_lineup(CoachNotes& notes, const WorldModel& world) {
  notes.used.assign(static_cast<std::size_t>(world.parameters->player.player_types), 0);
  for (const int type : world.our_types) {
    if (type >= 0 && static_cast<std::size_t>(type) < notes.used.size()) {
      ++notes.used[static_cast<std::size_t>(type)];
    }
  }
}

}  // namespace

void note_own_change(CoachNotes& notes, const WorldModel& world, int unum, int type) {
  notes.strength.replace(world, unum);
  if (world.game.time.cycle <= 0 || notes.used.empty()) return;
  ++notes.substitutions;
  if (type >= 0 && static_cast<std::size_t>(type) < notes.used.size()) {
    ++notes.used[static_cast<std::size_t>(type)];
  }
}

void take_notes(CoachNotes& notes, const WorldModel& world) {
  notes.analysis.look(world);
  notes.strength.look(world);
  if (notes.used.empty() && world.game.time.cycle > 0) count_lineup(notes, world);
}

bool may_say_freeform(const WorldModel& world, const CoachNotes& notes) {
  const soccer::ServerParams& server = world.server();
  const int most = server.say_coach_cnt_max;
  if (most >= 0 && notes.freeforms_said >= most) return false;
  if (world.game.mode != soccer::PlayMode::kPlayOn) return true;
  const int played = world.game.time.cycle - world.game.mode_start.cycle;
  return played > server.freeform_wait_period && server.freeform_wait_period > 0 &&
         played % server.freeform_wait_period < server.freeform_send_period;
}

}  // namespace cls::proxy
