// Messages of an rpc in memory that is used again: no allocation for each of their many parts.
#pragma once

#include <google/protobuf/arena.h>
#include <grpcpp/support/message_allocator.h>

#include <memory>
#include <mutex>
#include <vector>

namespace cls::mock_server {

/// Give it to a callback service with SetMessageAllocatorFor_METHOD(); it must outlive the server.
/// Keeps as many pairs of messages as were ever in use at the same time.
template <typename Request, typename Response>
class MessagePool : public grpc::MessageAllocator<Request, Response> {
 public:
  MessagePool() = default;
  MessagePool(const MessagePool&) = delete;
  MessagePool& operator=(const MessagePool&) = delete;
  ~MessagePool() override {
    // What gRPC's threads did to the messages is done before, by this lock at the latest.
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
    return pair.release();  // comes back in Release()
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
    // A State of a busy cycle fits; a larger one makes the arena grow for that call.
    static constexpr std::size_t kBlockSize = 96 * 1024;

    MessagePool& pool_;
    std::vector<char> block_;
    google::protobuf::Arena arena_;
  };

  std::mutex mutex_;
  std::vector<std::unique_ptr<Pair>> idle_;
};

}  // namespace cls::mock_server
