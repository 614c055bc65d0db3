// Stamina and capacity between two refills.
#include "analysis/measures/stamina.h"

#include <algorithm>

namespace cls::analysis {
namespace {

constexpr double kNoCapacity = -1.0;
// A capacity of six digits is printed without decimals: less is noise.
constexpr float kRefill = 2.0F;

// The consumption of one player; a segment ends where capacity grows.
class Meter {
 public:
  Meter(const gamelog::MatchRecord& record, std::size_t slot) : record_(record), slot_(slot) {}

  Stamina measure() {
    for (std::size_t i = 0; i < record_.frames(); ++i) {
      const std::size_t entry = entry_of(i, slot_);
      if (!gamelog::is_enabled(record_, entry)) continue;
      if (!begun_) begin(i);
      step(i);
    }
    if (begun_) end_segment();
    return result_;
  }

 private:
  float stamina(std::size_t frame) const { return record_.players.stamina[entry_of(frame, slot_)]; }
  float capacity(std::size_t frame) const {
    return record_.players.capacity[entry_of(frame, slot_)];
  }
  bool has_capacity() const { return record_.version >= gamelog::RcgVersion::kV5; }

  void begin(std::size_t frame) {
    begun_ = true;
    start_stamina_ = record_.server.stamina_max;
    start_capacity_ = record_.server.stamina_capacity;
    last_ = frame;
    result_.lowest = stamina(frame);
  }

  void step(std::size_t frame) {
    if (frame != last_ && has_capacity() && capacity(frame) > capacity(last_) + kRefill) {
      refill(frame);
    } else if (frame != last_ && !has_capacity()) {
      result_.used += used_by_rules(frame);
    }
    last_ = frame;
    const std::size_t entry = entry_of(frame, slot_);
    const soccer::ServerParams& server = record_.server;
    const double now = stamina(frame);
    result_.lowest = std::min(result_.lowest, now);
    result_.last = now;
    result_.last_capacity = has_capacity() ? capacity(frame) : kNoCapacity;
    const bool empty = has_capacity() && capacity(frame) == 0.0F;
    result_.exhausted_frames += empty || now < server.effort_dec_thr * server.stamina_max;
    result_.tired_frames += now < server.recover_dec_thr * server.stamina_max;
    result_.lowered_recovery_frames +=
        record_.players.recovery[entry] < static_cast<float>(server.recover_init);
    result_.lowered_effort_frames += record_.players.effort[entry] <
                                     static_cast<float>(type_of(record_, entry).effort_max) - 1e-5F;
  }

  // An extra half refills the capacity only; everything else both.
  void refill(std::size_t frame) {
    end_segment();
    ++result_.refills;
    const float most = stamina(last_) + static_cast<float>(record_.server.stamina_inc_max * 2);
    start_stamina_ = stamina(frame) > most ? record_.server.stamina_max : stamina(last_);
    start_capacity_ = record_.server.stamina_capacity;
  }

  // What is recovered comes out of the capacity, so the sum of both only sinks by what is used.
  void end_segment() {
    if (!has_capacity()) return;
    const double used = start_stamina_ - stamina(last_) + start_capacity_ - capacity(last_);
    result_.used += std::max(0.0, used);
  }

  // Before version 5: what he had and recovered, and has no more.
  double used_by_rules(std::size_t frame) const {
    const std::size_t entry = entry_of(frame, slot_);
    const double recovered = std::min<double>(
        record_.players.recovery[entry - gamelog::kSlots] * type_of(record_, entry).stamina_inc_max,
        record_.server.stamina_max - stamina(last_));
    return std::max(0.0, stamina(last_) + recovered - stamina(frame));
  }

  const gamelog::MatchRecord& record_;
  std::size_t slot_;
  Stamina result_;
  bool begun_ = false;
  std::size_t last_ = 0;
  double start_stamina_ = 0.0;
  double start_capacity_ = 0.0;
};

}  // namespace

PerPlayer<Stamina> stamina_of(const gamelog::MatchRecord& record) {
  PerPlayer<Stamina> result;
  if (record.version < gamelog::RcgVersion::kV3) return result;
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot)
    result[slot] = Meter(record, slot).measure();
  return result;
}

}  // namespace cls::analysis
