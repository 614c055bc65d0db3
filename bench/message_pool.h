// Request and response messages in reused memory: no allocation for each of their parts.
#pragma once

#include <google/protobuf/arena.h>
#include <grpcpp/support/message_allocator.h>

#include <memory>
#include <mutex>
#include <vector>

namespace cls::bench {

/// For a callback service: SetMessageAllocatorFor_METHOD(). Must outlive the server. Retains as
/// many pairs of messages as were in use at the same time.
template <typename Request, typename Response>
class MessagePool : public grpc::MessageAllocator<Request, Response> {
 public:
  MessagePool() = default;
  MessagePool(const MessagePool&) = delete;
  MessagePool& operator=(const MessagePool&) = delete;
  ~MessagePool() override {
    // Synchronizes with the last Release() on a thread of gRPC.
    const std::lock_guard lock(mutex_);
    idle_.clear();
  }

  grpc::MessageHolder<Request, Response>* AllocateMessages() override {
    std::unique_ptr<Pair> pair;
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        pair = std::move(idle_.back());
        idle_.pop_back();
      }
    }
    if (pair == nullptr) pair = std::make_unique<Pair>(*this);
    pair->prepare();
    return pair.release();  // Release() returns it to the pool
  }

 private:
  class Pair : public grpc::MessageHolder<Request, Response> {
   public:
    explicit Pair(MessagePool& pool)
        : pool_(pool), block_(kBlockSize), arena_(block_.data(), block_.size()) {}

    void prepare() {
      arena_.Reset();
      this->set_request(google::protobuf::Arena::CreateMessage<Request>(&arena_));
      this->set_response(google::protobuf::Arena::CreateMessage<Response>(&arena_));
    }

    void Release() override {
      const std::lock_guard lock(pool_.mutex_);
      pool_.idle_.emplace_back(this);
    }

   private:
    // Fits a State of a busy cycle; for a larger one the arena grows during that call.
    static constexpr std::size_t kBlockSize = 96 * 1024;

    MessagePool& pool_;
    std::vector<char> block_;
    google::protobuf::Arena arena_;
  };

  std::mutex mutex_;
  std::vector<std::unique_ptr<Pair>> idle_;
};

}  // namespace cls::bench
