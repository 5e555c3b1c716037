// How another program of the same user tells a running print what to do: a named pipe beside the
// print's journal, one request a line.
//
//     pause · resume · stop · cancel N     N: an object's number, from 1
//
// The pipe is there as long as the print is. Whoever writes to it does not wait, and gets no
// answer; what the print did is in its journal and on its terminal.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.h"             // Result, Status
#include "host/printing/controls.h"  // UserRequest

namespace host {

// A longer line is no request.
inline constexpr std::size_t kRequestBytesMax = 64;

struct TypedRequest {
  std::optional<UserRequest> request;  // nothing: an object is cancelled
  int object = 0;                      // its number
};

// Nothing: the line is no request.
[[nodiscard]] std::optional<TypedRequest> request_of_line(std::string_view line);

class RequestPipe {
 public:
  // Null: no pipe can be made there, or something else has its name. `journal`: of a print that
  // holds it. A pipe that a killed print has left is taken over.
  [[nodiscard]] static std::unique_ptr<RequestPipe> create(const std::string& journal);
  // Removes the pipe.
  ~RequestPipe();
  RequestPipe(const RequestPipe&) = delete;
  RequestPipe& operator=(const RequestPipe&) = delete;

  // The oldest request that nobody took; never waits. Lines that are none are skipped.
  [[nodiscard]] std::optional<TypedRequest> next();

 private:
  RequestPipe(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

  std::string path_;
  int descriptor_;
  std::string read_;           // at most kRequestBytesMax without an end of line
  bool skips_to_end_ = false;  // of a line that was too long
};

// Writes the request to the print that has this journal. An error: no such print runs.
[[nodiscard]] core::Status tell_print(const std::string& journal, const std::string& request);

}  // namespace host
