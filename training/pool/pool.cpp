// Steps and resets of pools.
#include "training/pool/pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.h"

namespace cls::training {
namespace {

// Of a thread's worlds: more do not stay in the caches of a processor core between two steps.
constexpr std::size_t kCachedBytes = 4 << 20;

// Starts to load `bytes` from `start` into the cache.
void prefetch(const void* start, std::size_t bytes) {
  constexpr std::size_t kCacheLine = 64;
  for (std::size_t i = 0; i < bytes; i += kCacheLine) {
    __builtin_prefetch(static_cast<const char*>(start) + i, 1, 2);
  }
}

}  // namespace

Pool::Pool(PoolConfig config)
    : config_(std::move(config)),
      crew_(base::index(config_.num_envs), base::index(config_.threads),
            [this](std::size_t begin, std::size_t end) { work(begin, end); }) {
  const auto count = base::index(config_.num_envs);
  worlds_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    worlds_.push_back({Episode(config_.setup), config_.options});
  }
}

void Pool::bind(const Buffers& buffers) {
  buffers_ = buffers;
  bound_ = true;
}

Outcome Pool::check_index(std::uint64_t env) const {
  if (env < worlds_.size()) return {};
  return {Code::kBadIndex, fmt::format("no world {}; the pool has {}", env, worlds_.size())};
}

Outcome Pool::reset(const std::uint8_t* mask, const std::uint64_t* seeds) {
  if (!bound_) return {Code::kBadOrder, "bind the buffers before the first reset"};
  for (std::size_t env = 0; env < worlds_.size(); ++env) {
    if (buffers_.was_reset != nullptr) buffers_.was_reset[env] = 0;
    if (mask == nullptr || mask[env] != 0) reset_world(env, seeds[env]);
  }
  return recording_outcome();
}

Outcome Pool::set_state(std::uint64_t env, std::uint64_t seed, const Start& start) {
  if (Outcome known = check_index(env); !known.ok()) return known;
  if (!bound_) return {Code::kBadOrder, "bind the buffers before the first state"};
  reset_world(env, seed, &start);
  return recording_outcome();
}

// Null: where the setup says.
void Pool::reset_world(std::size_t env, std::uint64_t seed, const Start* start) {
  Slot& slot = worlds_[env];
  if (slot.recording && slot.recording->running()) finish_recording(slot);
  if (start != nullptr) {
    slot.episode.reset_at(seed, slot.options, *start);
  } else {
    slot.episode.reset(seed, slot.options);
  }
  if (slot.recording) slot.recording->begin(slot.episode);
  fill_row(env, false);
  if (buffers_.was_reset != nullptr) buffers_.was_reset[env] = 1;
}

Outcome Pool::check_actions() const {
  const std::size_t agents = setup().agent_count();
  const auto ids = static_cast<std::int32_t>(setup().id_count());
  const std::size_t width = setup().id_width();
  const std::size_t values = setup().value_count();

  for (std::size_t row = 0; row < worlds_.size() * agents; ++row) {
    const std::size_t env = row / agents;
    const Episode& episode = worlds_[env].episode;
    if (episode.ended() || !episode.alive(row % agents)) continue;

    const auto where = [&] { return fmt::format("world {}, agent {}", env, row % agents); };
    const std::int32_t* chosen = buffers_.action_ids + row * width;
    if (ids > 0 && (*chosen < 0 || *chosen >= ids)) {
      return {Code::kBadAction,
              fmt::format("{}: action id {} is not in 0..{}", where(), *chosen, ids - 1)};
    }
    for (const SenseHead& head : setup().sense_heads) {
      const auto most = static_cast<std::int32_t>(head.items.size()) - 1;
      if (*++chosen >= 0 && *chosen <= most) continue;
      return {Code::kBadAction,
              fmt::format("{}: {} {} is not in 0..{}", where(), head.name, *chosen, most)};
    }

    for (std::size_t i = 0; i < values; ++i) {
      if (std::isfinite(buffers_.action_values[row * values + i])) continue;
      return {Code::kBadAction, fmt::format("{}: action value {} is not a finite number", where(),
                                            setup().value_columns[i].name)};
    }
  }
  return {};
}

Outcome Pool::step() {
  if (!bound_) return {Code::kBadOrder, "bind the buffers before the first step"};

  bool any = false;
  for (std::size_t env = 0; env < worlds_.size(); ++env) {
    const Episode& episode = worlds_[env].episode;
    if (!episode.started()) {
      return {Code::kBadOrder, fmt::format("reset world {} before the first step", env)};
    }
    any = any || !episode.ended();
  }

  if (!any && config_.autoreset == Autoreset::kDisabled) {
    return {Code::kBadOrder, "all episodes have ended; reset them before the next step"};
  }
  if (Outcome checked = check_actions(); !checked.ok()) return checked;

  crew_.run();
  return recording_outcome();
}

void Pool::work(std::size_t begin, std::size_t end) {
  const bool cached = (end - begin) * sizeof(Slot) <= kCachedBytes;
  for (std::size_t env = begin; env < end; ++env) {
    if (!cached && env + 1 < end) prefetch(&worlds_[env + 1], sizeof(Slot));
    step_world(env);
  }
}

void Pool::step_world(std::size_t env) {
  Slot& slot = worlds_[env];
  if (buffers_.was_reset != nullptr) buffers_.was_reset[env] = 0;

  if (slot.episode.ended()) {
    if (config_.autoreset != Autoreset::kDisabled) {
      return reset_world(env, buffers_.next_seeds[env]);
    }
    const std::size_t agents = setup().agent_count();
    std::fill_n(buffers_.rewards + env * agents, agents, 0.0F);
    if (buffers_.reward_terms != nullptr) {
      std::fill_n(buffers_.reward_terms + env * kRewardTerms, kRewardTerms, 0.0F);
    }
    return;
  }

  AgentActions actions;
  const std::size_t first = env * setup().agent_count();
  if (buffers_.action_ids != nullptr)
    actions.ids = buffers_.action_ids + first * setup().id_width();
  if (buffers_.action_values != nullptr) {
    actions.values = buffers_.action_values + first * setup().value_count();
  }

  const bool recorded = slot.recording && slot.recording->running();
  slot.episode.step(actions, recorded ? &slot.recording->recorder() : nullptr);
  fill_row(env, true);

  if (!slot.episode.ended()) return;
  if (recorded) finish_recording(slot);

  if (config_.autoreset != Autoreset::kSameStep) return;
  fill_views(env, buffers_.final_observations, buffers_.final_state);
  slot.episode.reset(buffers_.next_seeds[env], slot.options);
  if (slot.recording) slot.recording->begin(slot.episode);
  fill_views(env, buffers_.observations, buffers_.state);

  if (buffers_.seeds != nullptr) buffers_.seeds[env] = slot.episode.seed();
  if (buffers_.opponent != nullptr) buffers_.opponent[env] = slot.episode.opponent();
  if (buffers_.was_reset != nullptr) buffers_.was_reset[env] = 1;
}

void Pool::fill_views(std::size_t env, float* observations, float* state) {
  const Episode& episode = worlds_[env].episode;
  const std::size_t agents = setup().agent_count();
  const std::size_t features = setup().feature_count();
  const std::size_t ids = setup().id_count();

  if (observations != nullptr) episode.observe(observations + env * agents * features);
  for (std::size_t agent = 0; agent < agents; ++agent) {
    const std::size_t row = env * agents + agent;
    if (buffers_.alive != nullptr) buffers_.alive[row] = episode.alive(agent) ? 1 : 0;
    if (buffers_.action_masks != nullptr) episode.mask(agent, buffers_.action_masks + row * ids);
    if (buffers_.expert != nullptr) buffers_.expert[row] = episode.expert(agent);
  }

  if (state != nullptr) episode.state(state + env * setup().state_columns.size());
}

void Pool::fill_row(std::size_t env, bool step) {
  const Episode& episode = worlds_[env].episode;
  const std::size_t agents = setup().agent_count();
  fill_views(env, buffers_.observations, buffers_.state);

  for (std::size_t agent = 0; agent < agents; ++agent) {
    const std::size_t row = env * agents + agent;
    buffers_.rewards[row] = step ? static_cast<float>(episode.reward(agent)) : 0.0F;
    if (buffers_.illegal != nullptr) buffers_.illegal[row] = episode.illegal(agent);
  }

  const bool truncated = statuses()[base::index(episode.status())].truncated;
  buffers_.terminated[env] = episode.ended() && !truncated ? 1 : 0;
  buffers_.truncated[env] = episode.ended() && truncated ? 1 : 0;
  buffers_.status[env] = static_cast<std::int32_t>(episode.status());

  if (buffers_.reward_terms != nullptr) {
    for (std::size_t term = 0; term < kRewardTerms; ++term) {
      buffers_.reward_terms[env * kRewardTerms + term] =
          step ? static_cast<float>(episode.reward_term(term)) : 0.0F;
    }
  }

  if (buffers_.cycles != nullptr) buffers_.cycles[env] = episode.cycles();
  if (buffers_.score != nullptr) {
    buffers_.score[2 * env] = episode.score()[0];
    buffers_.score[2 * env + 1] = episode.score()[1];
  }
  if (buffers_.seeds != nullptr) buffers_.seeds[env] = episode.seed();
  if (buffers_.opponent != nullptr) buffers_.opponent[env] = episode.opponent();
}

Outcome Pool::set_options(std::int64_t env, const std::string& json) {
  if (env >= 0) {
    if (Outcome known = check_index(static_cast<std::uint64_t>(env)); !known.ok()) return known;
  }

  const auto first = env < 0 ? std::size_t{0} : base::index(env);
  const std::size_t last = env < 0 ? worlds_.size() : first + 1;
  for (std::size_t i = first; i < last; ++i) {
    const auto options = parse_options(*setup().task, json, worlds_[i].options);
    // The text is the same for all worlds, so only the first can be refused.
    if (!options) return {Code::kBadConfig, options.error().message};
    worlds_[i].options = *options;
  }
  return {};
}

Outcome Pool::snapshot(std::uint64_t env, std::uint64_t& handle) {
  if (Outcome known = check_index(env); !known.ok()) return known;
  if (!worlds_[env].episode.started()) {
    return {Code::kBadOrder, fmt::format("reset world {} before a snapshot", env)};
  }
  handle = next_snapshot_++;
  snapshots_.emplace(handle, worlds_[env].episode);
  return {};
}

Outcome Pool::restore(std::uint64_t env, std::uint64_t handle) {
  if (Outcome known = check_index(env); !known.ok()) return known;
  if (!bound_) return {Code::kBadOrder, "bind the buffers before a restore"};

  const auto found = snapshots_.find(handle);
  if (found == snapshots_.end()) {
    return {Code::kBadHandle, fmt::format("the pool has no snapshot {}", handle)};
  }

  worlds_[env].episode = found->second;
  fill_row(env, false);
  if (buffers_.was_reset != nullptr) buffers_.was_reset[env] = 0;
  return {};
}

Outcome Pool::release(std::uint64_t handle) {
  if (snapshots_.erase(handle) != 0) return {};
  return {Code::kBadHandle, fmt::format("the pool has no snapshot {}", handle)};
}

Outcome Pool::fork(std::uint64_t from, std::uint64_t to) {
  std::uint64_t handle = 0;
  if (Outcome known = check_index(to); !known.ok()) return known;
  if (Outcome copied = snapshot(from, handle); !copied.ok()) return copied;
  Outcome restored = restore(to, handle);
  snapshots_.erase(handle);
  return restored;
}

Outcome Pool::record(std::uint64_t env, const char* path) {
  if (Outcome known = check_index(env); !known.ok()) return known;
  Slot& slot = worlds_[env];
  if (slot.recording) finish_recording(slot);
  if (!slot.recording_error.empty())
    return {Code::kBadFile, std::exchange(slot.recording_error, {})};
  if (path == nullptr) return {};
  auto recording = Recording::create(path);
  if (!recording) return {Code::kBadFile, recording.error().message};
  slot.recording = std::move(*recording);
  return {};
}

void Pool::finish_recording(Slot& slot) {
  if (const auto done = slot.recording->finish(slot.episode); !done) {
    slot.recording_error = done.error().message;
  }
  slot.recording.reset();
}

Outcome Pool::recording_outcome() {
  for (Slot& slot : worlds_) {
    if (slot.recording_error.empty()) continue;
    return {Code::kBadFile, std::exchange(slot.recording_error, {})};
  }
  return {};
}

Outcome Pool::finish_recordings() {
  for (Slot& slot : worlds_) {
    if (slot.recording) finish_recording(slot);
  }
  return recording_outcome();
}

}  // namespace cls::training
