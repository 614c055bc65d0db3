// Sums steps of players, and consumed stamina from stamina and capacity between two refills.
#include "analysis/measures/physical.h"

#include <algorithm>

namespace cls::analysis {
namespace {

constexpr double kMaxStepFactor = 1.5;
constexpr std::array<double, kSpeedBandCount - 1> kBandLimits = {0.2, 0.6, 0.85};

std::size_t band_of(double share) {
  std::size_t band = 0;
  while (band < kBandLimits.size() && share >= kBandLimits[band]) ++band;
  return band;
}

constexpr double kNoCapacity = -1.0;
// Logs print a capacity of six digits without decimals: smaller increases are rounding.
constexpr float kRefill = 2.0F;

// Measures the consumption of one player; a segment ends where the capacity grows.
class StaminaMeter {
 public:
  StaminaMeter(const gamelog::MatchRecord& record, std::size_t slot)
      : record_(record), slot_(slot) {}

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

  // An extra half refills only the capacity; all other refills both.
  void refill(std::size_t frame) {
    end_segment();
    ++result_.refills;
    const float most = stamina(last_) + static_cast<float>(record_.server.stamina_inc_max * 2);
    start_stamina_ = stamina(frame) > most ? record_.server.stamina_max : stamina(last_);
    start_capacity_ = record_.server.stamina_capacity;
  }

  // Recovery is taken from the capacity, so the sum of both only decreases by consumption.
  void end_segment() {
    if (!has_capacity()) return;
    const double used = start_stamina_ - stamina(last_) + start_capacity_ - capacity(last_);
    result_.used += std::max(0.0, used);
  }

  // Before version 5: previous stamina plus recovery minus current stamina.
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

PerPlayer<Movement> measure_movement(const Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  PerPlayer<Movement> result;

  for (std::size_t i = 1; i < record.frames(); ++i) {
    if (record.time[i] < record.time[i - 1]) continue;
    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
      const std::size_t entry = entry_of(i, slot);
      const std::size_t before = entry - gamelog::kSlots;
      if (!gamelog::is_enabled(record, entry) || !gamelog::is_enabled(record, before)) continue;

      const double step =
          soccer::distance(record.players.position[entry], record.players.position[before]);
      const double top_speed = type_of(record, entry).player_speed_max;
      if (step > kMaxStepFactor * top_speed) continue;

      Movement& player = result[slot];
      if (!flow.is_live(i)) {
        player.other_distance += step;
        continue;
      }
      player.live_distance += step;
      player.top_speed = std::max(player.top_speed, step);
      ++player.bands[band_of(step / top_speed)];
    }
  }
  return result;
}

PerPlayer<Stamina> measure_stamina(const gamelog::MatchRecord& record) {
  PerPlayer<Stamina> result;
  if (record.version < gamelog::RcgVersion::kV3) return result;

  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    result[slot] = StaminaMeter(record, slot).measure();
  }
  return result;
}

}  // namespace cls::analysis
