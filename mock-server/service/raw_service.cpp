// Registering the RPCs, and one call of any of them, which may finish late or not at all.
#include "mock-server/service/raw_service.h"

#include <grpcpp/alarm.h>
#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/impl/codegen/rpc_service_method.h>
#include <grpcpp/impl/codegen/server_callback_handlers.h>
#include <grpcpp/support/server_callback.h>

#include <chrono>
#include <mutex>
#include <utility>

namespace cls::mock_server {

using google::protobuf::Message;
using grpc::ByteBuffer;
using proto::Rpc;

namespace {

using MessageTraits = grpc::SerializationTraits<Message>;

// INTERNAL when the bytes are not a message of this type.
grpc::Status parse(const ByteBuffer& bytes, Message& message) {
  ByteBuffer copy = bytes;  // of references to the slices; Deserialize() clears it
  if (MessageTraits::Deserialize(&copy, &message).ok()) return grpc::Status::OK;
  return {grpc::StatusCode::INTERNAL, "the request does not parse"};
}

grpc::Status serialize(const Message& message, ByteBuffer& bytes) {
  bool own_buffer = false;
  return MessageTraits::Serialize(message, &bytes, &own_buffer);
}

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
grpc::ServerUnaryReactor* finish(const Response& response, grpc::CallbackServerContext& context) {
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

}  // namespace

RawService::RawService(int first, int end, std::size_t memory, Respond respond)
    : respond_(std::move(respond)), workspaces_(memory) {
  for (int i = first; i < end; ++i) {
    // As the generated Service and WithRawCallbackMethod_NAME do for each method.
    const auto rpc = static_cast<Rpc>(i);
    AddMethod(new grpc::internal::RpcServiceMethod(path(rpc).c_str(),
                                                   grpc::internal::RpcMethod::NORMAL_RPC, nullptr));
    MarkMethodRawCallback(
        i - first,
        new grpc::internal::CallbackUnaryHandler<ByteBuffer, ByteBuffer>(
            [this, rpc](grpc::CallbackServerContext* context, const ByteBuffer* request,
                        ByteBuffer* reply) { return handle(rpc, *context, *request, *reply); }));
  }
}

grpc::ServerUnaryReactor* RawService::handle(Rpc rpc, grpc::CallbackServerContext& context,
                                             const ByteBuffer& request, ByteBuffer& reply) {
  auto workspace = workspaces_.acquire();
  Message& parsed = workspace->create(request_prototype(rpc));
  Message& message = workspace->create(reply_prototype(rpc));

  Response response;
  response.status = parse(request, parsed);
  if (response.status.ok()) response = respond_(rpc, parsed, message, *workspace);

  if (response.bytes) {
    const grpc::Slice slice(*response.bytes);
    reply = ByteBuffer(&slice, 1);
  } else if (response.status.ok() && !response.hangs) {
    response.status = serialize(message, reply);
  }

  workspaces_.release(std::move(workspace));
  return finish(response, context);
}

}  // namespace cls::mock_server
