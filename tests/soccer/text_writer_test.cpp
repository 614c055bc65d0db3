// TextWriter compared with std::string.
#include "soccer/protocol/text_writer.h"

#include <gtest/gtest.h>

#include <string>

#include "base/text/number_text.h"

namespace cls::soccer {
namespace {

TEST(TextWriter, AppendsLikeStdStringAtAllLengths) {
  std::string plain = "before ";
  std::string text = plain;

  {
    TextWriter out(text);
    for (int i = 0; i < 2000; ++i) {
      append(out, "(n ", i - 1000);
      append(out, " ", 0.25 * i);
      out.push_back(')');
      out += std::string(static_cast<std::size_t>(i % 50), 'x');
      append(plain, "(n ", i - 1000);
      plain += ' ';
      base::append_g(0.25 * i, plain);
      plain += ')' + std::string(static_cast<std::size_t>(i % 50), 'x');
    }
    out.append({});
    out.append(std::string(10000, 'y'));
    plain += std::string(10000, 'y');
  }

  EXPECT_EQ(text, plain);
}

}  // namespace
}  // namespace cls::soccer
