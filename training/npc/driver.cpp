// Drawing a driver.
#include "training/npc/driver.h"

namespace cls::training {

int draw_driver(const DriverPool& pool, soccer::RandomStream& random) {
  double left = 0.0;
  for (const DriverShare& share : pool) left += share.weight;
  left *= random.unit();

  int last = -1;  // with a positive weight
  for (std::size_t i = 0; i < pool.size(); ++i) {
    if (pool[i].weight <= 0.0) continue;
    last = static_cast<int>(i);
    left -= pool[i].weight;
    if (left < 0.0) break;
  }
  return last;
}

}  // namespace cls::training
