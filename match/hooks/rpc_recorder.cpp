// Collects the calls of a cycle, then writes them in order.
#include "match/hooks/rpc_recorder.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>

#include <algorithm>

#include "match/saved/saved_match.h"
#include "proto/status_name.h"

namespace cls::match {
namespace {

using base::Error;

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

bool CallsOfSide::has_call(int agent, proto::Rpc rpc) const {
  return std::ranges::any_of(calls_, [&](const recording::RecordedCall& call) {
    return call.status() == 0 && call.agent() == agent && call.rpc() == name(rpc);
  });
}

void CallsOfSide::on_call(const proxy::RpcCall& call) {
  // A late reply in real time falls into the next cycle; each agent decides once in a step.
  if (is_decision(call.rpc) && has_call(call.agent, call.rpc)) end_cycle();

  recording::RecordedCall& recorded = calls_.emplace_back();
  recorded.set_side(side_number(side_));
  recorded.set_agent(call.agent);
  recorded.set_rpc(std::string(name(call.rpc)));
  recorded.set_step(step_);
  write_deterministically(call.request, *recorded.mutable_request());
  if (call.reply != nullptr) write_deterministically(*call.reply, *recorded.mutable_reply());

  recorded.set_status(call.status.code);
  if (!call.status.ok()) {
    // An exceeded deadline has no status of the Playmaker.
    if (call.status.code == 0) recorded.set_status(proto::kStatusUnknown);
    recorded.set_message(call.status.message);
  }
}

void CallsOfSide::flush() {
  std::ranges::stable_sort(calls_, {}, &recording::RecordedCall::agent);
  recorder_.write(calls_);
  calls_.clear();
}

void CallsOfSide::end_cycle() {
  flush();
  ++step_;
}

void RpcRecorder::write(const std::vector<recording::RecordedCall>& calls) {
  const std::lock_guard lock(mutex_);
  for (const recording::RecordedCall& call : calls) writer_->write(call);
}

std::string RpcRecorder::close() {
  for (CallsOfSide* side : {&sides_.left, &sides_.right}) side->flush();
  const std::lock_guard lock(mutex_);
  return writer_->close();
}

base::Result<void> write_error_recording(const std::filesystem::path& file,
                                         const recording::RecordingHeader& header,
                                         soccer::Side side, const proxy::PlaymakerError& error) {
  std::string problem;
  const auto writer = proto::RecordingWriter::create(file.string(), header, problem);
  if (writer == nullptr) return Error{problem};

  for (recording::RecordedCall call : error.calls) {
    call.set_side(side_number(side));
    writer->write(call);
  }
  problem = writer->close();
  if (!problem.empty()) return Error{problem};
  return {};
}

}  // namespace cls::match
