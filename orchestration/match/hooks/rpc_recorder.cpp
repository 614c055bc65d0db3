// Collecting the calls of a cycle, then writing them in order.
#include "orchestration/match/hooks/rpc_recorder.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>

#include <algorithm>

namespace cls::orchestration::match {

using base::Error;

namespace {

constexpr int kUnknownStatus = 2;  // gRPC's UNKNOWN

}  // namespace

namespace {

// Maps of a message are written in an order of their own in every process unless told otherwise.
void write_repeatably(const google::protobuf::Message& message, std::string& bytes) {
  google::protobuf::io::StringOutputStream stream(&bytes);
  google::protobuf::io::CodedOutputStream coded(&stream);
  coded.SetSerializationDeterministic(true);
  message.SerializeToCodedStream(&coded);
}

}  // namespace

base::Result<std::unique_ptr<RpcRecorder>> RpcRecorder::create(
    const std::filesystem::path& file, const recording::RecordingHeader& header) {
  std::string error;
  auto writer = proto::RecordingWriter::create(file.string(), header, error);
  if (writer == nullptr) return Error{error};
  return std::unique_ptr<RpcRecorder>(new RpcRecorder(std::move(writer)));
}

proxy::RpcListener* RpcRecorder::listener(soccer::Side side) {
  return &ears_[side == soccer::Side::kRight ? 1 : 0];
}

void RpcRecorder::Ear::on_call(const proxy::RpcCall& call) {
  recording::RecordedCall& recorded = calls_.emplace_back();
  recorded.set_side(side_);
  recorded.set_agent(call.agent);
  recorded.set_rpc(std::string(name(call.rpc)));
  recorded.set_step(step_);
  write_repeatably(call.request, *recorded.mutable_request());
  if (call.reply != nullptr) write_repeatably(*call.reply, *recorded.mutable_reply());
  recorded.set_status(call.status.code);
  if (!call.status.ok()) {
    // A deadline of ours has no status of the Playmaker's.
    if (call.status.code == 0) recorded.set_status(kUnknownStatus);
    recorded.set_message(call.status.message);
  }
}

void RpcRecorder::Ear::write_to(proto::RecordingWriter& writer) {
  std::stable_sort(calls_.begin(), calls_.end(),
                   [](const auto& a, const auto& b) { return a.agent() < b.agent(); });
  for (const recording::RecordedCall& call : calls_) writer.write(call);
  calls_.clear();
}

void RpcRecorder::flush() {
  for (Ear& ear : ears_) ear.write_to(*writer_);
}

void RpcRecorder::arrange(simulator::World& /*world*/, simulator::Events& /*events*/) {
  flush();
  step_ = 1;
}

bool RpcRecorder::after_cycle(const simulator::World& /*world*/) {
  flush();
  ++step_;
  return true;
}

std::string RpcRecorder::close() {
  flush();
  return writer_->close();
}

}  // namespace cls::orchestration::match
