// Registering the RPCs, and one call of any of them.
#include "mock-server/service/raw_service.h"

#include <grpcpp/impl/codegen/rpc_service_method.h>
#include <grpcpp/impl/codegen/server_callback_handlers.h>

#include <utility>

#include "mock-server/service/delayed_reply.h"

namespace cls::mock_server {

using google::protobuf::Message;
using grpc::ByteBuffer;
using proto::Rpc;

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
    reply = buffer_of(*response.bytes);
  } else if (response.status.ok() && !response.hangs) {
    response.status = serialize(message, reply);
  }

  workspaces_.release(std::move(workspace));
  return finish(response, context);
}

}  // namespace cls::mock_server
