// Flushes standard output and looks for writes that failed.
#include "cli/support/finish_output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "base/io/standard_streams.h"
#include "cli/support/print_error.h"

namespace cls::cli {

int finish_output(int exit_code) {
  std::fflush(stdout);
  const int output = base::write_error(base::StandardStream::kOutput);
  const int errors = base::write_error(base::StandardStream::kError);
  if (output == 0 && errors == 0) return exit_code;

  const int failed = exit_code == kOk ? static_cast<int>(kWriteFailed) : exit_code;
  if (output == 0 || output == EPIPE) return failed;
  return print_error(failed, std::string("cannot write standard output: ") + std::strerror(output));
}

}  // namespace cls::cli
