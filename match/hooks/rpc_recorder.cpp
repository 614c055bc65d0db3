// Collects the calls of a cycle, then writes them in order.
#include "match/hooks/rpc_recorder.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>

#include <algorithm>

namespace cls::match {
namespace {

using base::Error;

constexpr int kUnknownStatus = 2;  // gRPC's UNKNOWN

// Without this, each process writes the entries of maps in another order.
void write_deterministically(const google::protobuf::Message& message, std::string& bytes) {
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

SideListener* RpcRecorder::listener(soccer::Side side) {
  return &sides_[side == soccer::Side::kRight ? 1 : 0];
}

bool RpcRecorder::SideRecorder::has_call(int agent, proto::Rpc rpc) const {
  return std::any_of(calls_.begin(), calls_.end(), [&](const recording::RecordedCall& call) {
    return call.status() == 0 && call.agent() == agent && call.rpc() == name(rpc);
  });
}

void RpcRecorder::SideRecorder::on_call(const proxy::RpcCall& call) {
  // A late reply in real time falls into the next cycle; each agent decides once in a step.
  if (is_decision(call.rpc) && has_call(call.agent, call.rpc)) end_cycle();
  recording::RecordedCall& recorded = calls_.emplace_back();
  recorded.set_side(side_);
  recorded.set_agent(call.agent);
  recorded.set_rpc(std::string(name(call.rpc)));
  recorded.set_step(step_);
  write_deterministically(call.request, *recorded.mutable_request());
  if (call.reply != nullptr) write_deterministically(*call.reply, *recorded.mutable_reply());
  recorded.set_status(call.status.code);
  if (!call.status.ok()) {
    // An exceeded deadline has no status of the Playmaker.
    if (call.status.code == 0) recorded.set_status(kUnknownStatus);
    recorded.set_message(call.status.message);
  }
}

void RpcRecorder::SideRecorder::flush() {
  std::stable_sort(calls_.begin(), calls_.end(),
                   [](const auto& a, const auto& b) { return a.agent() < b.agent(); });
  recorder_.write(calls_);
  calls_.clear();
}

void RpcRecorder::SideRecorder::end_cycle() {
  flush();
  ++step_;
}

void RpcRecorder::write(const std::vector<recording::RecordedCall>& calls) {
  const std::lock_guard lock(mutex_);
  for (const recording::RecordedCall& call : calls) writer_->write(call);
}

std::string RpcRecorder::close() {
  for (SideRecorder& side : sides_) side.flush();
  const std::lock_guard lock(mutex_);
  return writer_->close();
}

}  // namespace cls::match
