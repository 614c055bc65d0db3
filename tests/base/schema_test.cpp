// Versions of stored documents.
#include "base/text/schema.h"

#include <gtest/gtest.h>

namespace cls::base {
namespace {

TEST(Schema, AcceptsTheNewestVersionAndOlderOnes) {
  EXPECT_EQ(schema_error("cls.match/1", "cls.match/1"), std::nullopt);
  EXPECT_EQ(schema_error("cls.match/1", "cls.match/3"), std::nullopt);
}

TEST(Schema, RefusesNewerVersionsAndOtherFormats) {
  EXPECT_EQ(schema_error("cls.match/2", "cls.match/1"),
            "schema cls.match/2 is newer than this cls reads (cls.match/1); update cls");
  for (const char* other : {"cls.view/1", "cls.match", "cls.match/", "cls.match/x", "cls.match/0",
                            "cls.match/1x", ""}) {
    EXPECT_EQ(schema_error(other, "cls.match/1"),
              "schema '" + std::string(other) + "' is not cls.match/1");
  }
}

TEST(Schema, OfANumberAlone) {
  EXPECT_EQ(schema_error(1, 2), std::nullopt);
  EXPECT_EQ(schema_error(2, 2), std::nullopt);
  EXPECT_EQ(schema_error(3, 2), "schema 3 is newer than this cls reads (2); update cls");
  EXPECT_EQ(schema_error(0, 2), "schema: must be a whole number from 1 to 2");
}

}  // namespace
}  // namespace cls::base
