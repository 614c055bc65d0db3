// A call of the callback service that finishes late or not at all.
#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/support/server_callback.h>

#include <chrono>
#include <mutex>
#include <utility>

#include "mock-server/service/responder.h"

namespace cls::mock_server {

/// Deletes itself when the call is done.
class DelayedReply : public grpc::ServerUnaryReactor {
 public:
  void finish_after(int milliseconds, grpc::Status status) {
    const auto when = std::chrono::system_clock::now() + std::chrono::milliseconds(milliseconds);
    alarm_.Set(when, [this, status](bool /*fired*/) { Finish(status); });
  }

  void hang() {
    const std::lock_guard lock(mutex_);
    hanging_ = true;
    if (cancelled_) Finish(grpc::Status::CANCELLED);
  }

  void OnCancel() override {
    const std::lock_guard lock(mutex_);
    cancelled_ = true;
    if (hanging_) Finish(grpc::Status::CANCELLED);
  }

  void OnDone() override { delete this; }

 private:
  grpc::Alarm alarm_;
  std::mutex mutex_;
  bool cancelled_ = false;
  bool hanging_ = false;
};

/// Ends a call as `response` says.
inline grpc::ServerUnaryReactor* finish(const Response& response,
                                        grpc::CallbackServerContext& context) {
  if (!response.hangs && response.delay_ms <= 0) {
    grpc::ServerUnaryReactor* reactor = context.DefaultReactor();
    reactor->Finish(response.status);
    return reactor;
  }

  auto* reactor = new DelayedReply;
  if (response.hangs) {
    reactor->hang();
  } else {
    reactor->finish_after(response.delay_ms, response.status);
  }

  return reactor;
}

}  // namespace cls::mock_server
