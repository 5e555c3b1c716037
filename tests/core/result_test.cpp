#include "core/result.h"

#include <doctest/doctest.h>

#include <string>

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;

TEST_CASE("a result holds either its value or its error") {
  const Result<std::string> good(std::string("slice"));
  REQUIRE(good.ok());
  CHECK_EQ(good.value(), "slice");

  const Result<std::string> bad(Error{ErrorCode::kBadPart, "facet 7: not a number"});
  REQUIRE_FALSE(bad.ok());
  CHECK_EQ(bad.error().code, ErrorCode::kBadPart);
  CHECK_EQ(bad.error().message, "facet 7: not a number");
}

TEST_CASE("a status is fine until it is given an error") {
  CHECK(Status().ok());
  CHECK_FALSE(Status(Error{ErrorCode::kUnreadable, "no such file"}).ok());
}
