// Predictions must be readable again, and cut files a start of the whole ones.
#include "tests/fuzz/table_checks.h"

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

#include "analysis/tables/stp_challenge.h"
#include "base/io/byte_sink.h"
#include "base/io/byte_source.h"
#include "base/text/replace_all.h"
#include "tests/fuzz/require.h"

namespace cls::tests {
namespace {

using analysis::StpColumns;
using analysis::StpFile;
using analysis::StpModel;
using base::MemorySource;

void check_cut(std::string_view bytes, StpFile file, int last_cycle) {
  MemorySource source(bytes);
  base::StringSink sink;
  static_cast<void>(analysis::cut_stp_file(source, file, last_cycle, sink));
  std::string whole(bytes);
  base::replace_all(whole, "\r\n", "\n");
  require(whole.starts_with(sink.bytes()), "a cut file is a start of the whole one");
}

void check_prediction(const analysis::StpRow& last, StpModel model) {
  const std::string table = analysis::format_stp_prediction(analysis::predict_stp(model, last));
  MemorySource source(table);
  const auto again = analysis::read_stp_prediction(source, StpColumns::kAllPlaces);
  require(again.ok(), "a written prediction can be read");
  require(!analysis::check_stp_prediction(*again, last.number), "a written prediction is valid");
  MemorySource truth(table);
  require(analysis::score_stp_prediction(*again, truth, last.number).ok(),
          "a prediction has a score against itself");
}

}  // namespace

void check_table(std::string_view bytes) {
  for (const StpFile file :
       {StpFile::kTracking, StpFile::kEvents, StpFile::kGameLog, StpFile::kTextLog}) {
    check_cut(bytes, file, 100);
    check_cut(bytes, file, std::numeric_limits<int>::min());
  }
  MemorySource match(bytes);
  static_cast<void>(analysis::stp_last_cycle(match));
  MemorySource test(bytes);
  const auto last = analysis::read_last_stp_row(test, StpColumns::kMotion);
  if (!last) return;
  check_prediction(*last, StpModel::kVelocity);
  check_prediction(*last, StpModel::kGoal);
}

}  // namespace cls::tests
