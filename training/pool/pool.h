// Many worlds that play episodes of one task, on several threads.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "training/episode/episode.h"
#include "training/pool/crew.h"
#include "training/pool/pool_config.h"
#include "training/pool/recording.h"

namespace cls::training {

/// Numbers are part of the C interface (training/c_api/cls_training.h describes them).
enum class Code : int {
  kOk = 0,
  kBadPointer = -1,
  kBadHandle = -2,
  kBadConfig = -3,
  kBadSize = -4,
  kBadIndex = -5,
  kBadAction = -6,
  kBadOrder = -7,
  kBadFile = -8,
  kSmallBuffer = -9,
  kForked = -10,
  kInternal = -11,
};

/// `text` is empty for kOk.
struct [[nodiscard]] Outcome {
  Code code = Code::kOk;
  std::string text{};

  bool ok() const { return code == Code::kOk; }
};

/// Arrays of a pool, owned by the caller. Shapes and meanings: training/c_api/cls_training.h. Null
/// pointers are not filled.
struct Buffers {
#define CLS_TRAINING_ARRAY(type, name, count, needed) type* name = nullptr;
#include "training/pool/arrays.inc"
};

/// Meanings of all functions: training/c_api/cls_training.h. Not for concurrent use.
class Pool {
 public:
  explicit Pool(PoolConfig config);

  const PoolConfig& config() const { return config_; }
  const Setup& setup() const { return *config_.setup; }
  std::size_t size() const { return worlds_.size(); }
  int threads() const { return static_cast<int>(crew_.threads()); }

  /// The arrays have the sizes that the setup needs, and those that are needed are given.
  void bind(const Buffers& buffers);
  bool bound() const { return bound_; }
  /// `mask` may be null: all worlds.
  Outcome reset(const std::uint8_t* mask, const std::uint64_t* seeds);
  Outcome step();
  /// Starts an episode from a state.
  Outcome set_state(std::uint64_t env, std::uint64_t seed, const Start& start);
  /// A negative index means all worlds.
  Outcome set_options(std::int64_t env, const std::string& json);

  Outcome snapshot(std::uint64_t env, std::uint64_t& handle);
  Outcome restore(std::uint64_t env, std::uint64_t handle);
  Outcome release(std::uint64_t handle);
  Outcome fork(std::uint64_t from, std::uint64_t to);

  /// Null stops and forgets a recording.
  Outcome record(std::uint64_t env, const char* path);
  /// Writes the recordings that are not complete yet.
  Outcome finish_recordings();

  /// The index must exist.
  const Episode& episode(std::uint64_t env) const { return worlds_[env].episode; }

 private:
  struct Slot {
    Episode episode;
    OptionValues options;
    std::unique_ptr<Recording> recording{};
    std::string recording_error{};
  };

  Outcome check_index(std::uint64_t env) const;
  Outcome check_actions() const;
  Outcome recording_outcome();
  void work(std::size_t begin, std::size_t end);
  void step_world(std::size_t env);
  void reset_world(std::size_t env, std::uint64_t seed, const Start* start = nullptr);
  void finish_recording(Slot& slot);
  void fill_row(std::size_t env, bool step);
  void fill_views(std::size_t env, float* observations, float* state);

  PoolConfig config_;
  std::vector<Slot> worlds_;
  Crew crew_;
  Buffers buffers_;
  bool bound_ = false;
  std::map<std::uint64_t, Episode> snapshots_;
  std::uint64_t next_snapshot_ = 1;
};

}  // namespace cls::training
