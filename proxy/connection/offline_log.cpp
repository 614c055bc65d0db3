// A channel that records what it receives.
#include "proxy/connection/offline_log.h"

#include <fmt/format.h>

#include <filesystem>
#include <string_view>
#include <utility>
#include <variant>

#include "soccer/messages/server_reply.h"

namespace cls::proxy {

class OfflineLogs::File {
 public:
  File(std::string stem, int unum) : stem_(std::move(stem)), unum_(unum) {}

  void write_received(std::string_view message) {
    if (sink_ == nullptr && !open(message)) return;
    if (message.starts_with("(server_param ")) {
      synchronous_ = message.find("(synch_mode 1)") != std::string_view::npos;
    }
    in_play_ = in_play_ || message.starts_with("(sense_body ");
    write(message);
  }

  void write_sent() {
    if (sink_ != nullptr && in_play_ && !synchronous_) write("(think)");
  }

  std::string close() {
    if (sink_ == nullptr || !error_.empty()) return error_;
    const auto closed = sink_->close();
    return closed ? std::string() : closed.error().message;
  }

 private:
  // With the reply to init, which has the number.
  bool open(std::string_view message) {
    soccer::ServerReply reply;
    if (!error_.empty() || !parse(message, reply)) return false;
    if (const auto* init = std::get_if<soccer::PlayerInitReply>(&reply)) unum_ = init->unum;
    const bool accepted = std::holds_alternative<soccer::PlayerInitReply>(reply) ||
                          std::holds_alternative<soccer::ReconnectReply>(reply);
    if (!accepted) return false;

    auto created = base::FileSink::create(fmt::format("{}-{}.ocl", stem_, unum_));
    if (created) {
      sink_ = *std::move(created);
    } else {
      error_ = created.error().message;
    }
    return sink_ != nullptr;
  }

  void write(std::string_view line) {
    sink_->write(line);
    sink_->write("\n");
  }

  std::string stem_;
  int unum_;
  bool synchronous_ = false;
  bool in_play_ = false;
  std::unique_ptr<base::FileSink> sink_;
  std::string error_;
};

namespace {

class RecordedChannel : public soccer::Channel {
 public:
  RecordedChannel(std::unique_ptr<soccer::Channel> inner, std::shared_ptr<OfflineLogs::File> file)
      : inner_(std::move(inner)), file_(std::move(file)) {}

  bool send(std::string_view message) override {
    if (!message.starts_with("(bye)")) file_->write_sent();
    return inner_->send(message);
  }
  bool receive(std::string& message) override {
    if (!inner_->receive(message)) return false;
    file_->write_received(message);
    return true;
  }
  bool can_compress() const override { return inner_->can_compress(); }
  void compress(int level) override { inner_->compress(level); }
  std::chrono::steady_clock::time_point received_at() const override {
    return inner_->received_at();
  }

 private:
  std::unique_ptr<soccer::Channel> inner_;
  std::shared_ptr<OfflineLogs::File> file_;
};

}  // namespace

std::unique_ptr<soccer::Channel> OfflineLogs::record(std::unique_ptr<soccer::Channel> inner,
                                                     int unum) {
  const std::string stem = (std::filesystem::path(folder_) / team_).string();
  files_.push_back(std::make_shared<File>(stem, unum));
  return std::make_unique<RecordedChannel>(std::move(inner), files_.back());
}

std::string OfflineLogs::close() {
  std::string first;
  for (const auto& file : files_) {
    if (std::string error = file->close(); first.empty()) first = std::move(error);
  }
  return first;
}

}  // namespace cls::proxy
