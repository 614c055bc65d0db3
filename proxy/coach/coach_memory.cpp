// Updating the memory.
#include "proxy/coach/coach_memory.h"

#include <iterator>

#include "base/index.h"

namespace cls::proxy {
namespace {

void count_use(CoachMemory& memory, int type) {
  if (type >= 0 && type < std::ssize(memory.used)) ++memory.used[base::index(type)];
}

// Types on the field at the kick-off count as used.
void count_lineup(CoachMemory& memory, const player::WorldModel& world) {
  memory.used.assign(base::index(world.parameters->player.player_types), 0);
  for (const int type : world.our_types) count_use(memory, type);
}

}  // namespace

void record_type_change(CoachMemory& memory, const player::WorldModel& world, int unum, int type) {
  memory.stamina.replace(world, unum);
  if (world.game.time.cycle <= 0 || memory.used.empty()) return;
  ++memory.substitutions;
  count_use(memory, type);
}

void update_memory(CoachMemory& memory, const player::WorldModel& world) {
  memory.analysis.update(world);
  memory.stamina.update(world);
  if (memory.used.empty() && world.game.time.cycle > 0) count_lineup(memory, world);
}

void record_refused_types(CoachMemory& memory) {
  if (memory.said_in_vain || memory.freeforms_sent == 0) return;  // not about our message
  memory.said_in_vain = true;
  --memory.freeforms_sent;
}

bool has_types_to_say(const player::WorldModel& world, const CoachMemory& memory) {
  if (world.their_types != memory.said_types) return true;
  return memory.said_in_vain && !(world.game.mode_start == memory.said_in);
}

bool can_say_freeform(const player::WorldModel& world, const CoachMemory& memory) {
  const soccer::ServerParams& server = world.server();
  const int most = server.say_coach_cnt_max;
  if (most >= 0 && memory.freeforms_sent >= most) return false;
  if (world.game.mode != soccer::PlayMode::kPlayOn) return true;
  const int played = world.game.time.cycle - world.game.mode_start.cycle;
  return played > server.freeform_wait_period && server.freeform_wait_period > 0 &&
         played % server.freeform_wait_period < server.freeform_send_period;
}

}  // namespace cls::proxy
