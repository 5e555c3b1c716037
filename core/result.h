// What an operation that can meet bad input or bad weather returns. Our own bugs go to RIND_CHECK.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "core/check.h"

namespace core {

// The closed list of what can go wrong without being our bug.
enum class ErrorCode {
  kBadSetting,   // a setting out of range, or two that do not fit together
  kBadPart,      // the part's file: what it says can't be printed or can't be understood
  kUnreadable,   // a file that can't be opened, read or written
  kNoMemory,     // a layer needs more memory than there is or may be used
  kOutOfBounds,  // the part is larger than the bed, the axes or the coordinate range
};

// Names the place (file and line, byte, facet or layer) and the cause, and what to do about it.
struct Error {
  ErrorCode code;
  std::string message;
};

template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool ok() const { return value_.has_value(); }

  // REQUIRES: ok()
  [[nodiscard]] const T& value() const& {
    RIND_CHECK(ok());
    return *value_;
  }
  [[nodiscard]] T& value() & {
    RIND_CHECK(ok());
    return *value_;
  }
  [[nodiscard]] T&& value() && {
    RIND_CHECK(ok());
    return *std::move(value_);
  }

  // REQUIRES: !ok()
  [[nodiscard]] const Error& error() const {
    RIND_CHECK(!ok());
    return *error_;
  }

 private:
  std::optional<T> value_;
  std::optional<Error> error_;
};

// A Result without a value.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Error error) : error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool ok() const { return !error_.has_value(); }

  // REQUIRES: !ok()
  [[nodiscard]] const Error& error() const {
    RIND_CHECK(!ok());
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace core
