// Reads a file behind its writer.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "base/index.h"
#include "base/system/unique_fd.h"
#include "viewer/live/live_input.h"

namespace cls::viewer {
namespace {

class LogInput : public LiveInput {
 public:
  LogInput(std::filesystem::path log, std::function<bool()> complete)
      : log_(std::move(log)), complete_(std::move(complete)) {}

  std::size_t read(char* to, std::size_t size) override {
    if (!file_) file_ = base::UniqueFd(::open(log_.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file_) return 0;

    ssize_t count = 0;
    do {
      count = ::read(file_.get(), to, size);
    } while (count < 0 && errno == EINTR);
    if (count <= 0) return 0;
    offset_ += count;
    return base::index(count);
  }

  bool knows_its_end() const override { return complete_ != nullptr; }

  // What the writer wrote before it closed the file may have come after the last read().
  State state() override {
    struct stat status = {};
    if (file_ && ::fstat(file_.get(), &status) == 0) {
      if (status.st_size < offset_) return State::kEnded;
      if (status.st_size > offset_) return State::kOpen;
    }

    if (last_look_) return State::kEnded;
    last_look_ = complete_ && complete_();
    return State::kOpen;
  }

 private:
  std::filesystem::path log_;
  std::function<bool()> complete_;
  base::UniqueFd file_;
  off_t offset_ = 0;
  bool last_look_ = false;
};

}  // namespace

std::unique_ptr<LiveInput> follow_log(std::filesystem::path log, std::function<bool()> complete) {
  return std::make_unique<LogInput>(std::move(log), std::move(complete));
}

}  // namespace cls::viewer
