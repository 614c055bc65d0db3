// Parsing and serializing, and the pool.
#include "mock-server/service/raw_call.h"

#include <grpcpp/impl/codegen/proto_utils.h>

#include <utility>

namespace cls::mock_server {

using google::protobuf::Message;
using MessageTraits = grpc::SerializationTraits<Message>;

grpc::Status parse(const grpc::ByteBuffer& bytes, Message& message) {
  grpc::ByteBuffer copy = bytes;  // of references to the slices; Deserialize() clears it
  const grpc::Status status = MessageTraits::Deserialize(&copy, &message);
  if (status.ok()) return status;
  return {grpc::StatusCode::INTERNAL, "the request does not parse"};
}

grpc::Status serialize(const Message& message, grpc::ByteBuffer& bytes) {
  bool own_buffer = false;
  return MessageTraits::Serialize(message, &bytes, &own_buffer);
}

grpc::ByteBuffer buffer_of(const std::string& bytes) {
  const grpc::Slice slice(bytes);
  return grpc::ByteBuffer(&slice, 1);
}

std::unique_ptr<Workspace> WorkspacePool::acquire() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return std::make_unique<Workspace>(size_);
  auto workspace = std::move(idle_.back());
  idle_.pop_back();
  return workspace;
}

void WorkspacePool::release(std::unique_ptr<Workspace> workspace) {
  workspace->reset();
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(workspace));
}

}  // namespace cls::mock_server
