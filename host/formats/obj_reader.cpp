#include "host/formats/obj_reader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "host/files/mapped_array.h"    // MappedArray
#include "host/formats/number_text.h"   // parse_real
#include "host/formats/text_scanner.h"  // TextScanner
#include "host/formats/vertex_snap.h"   // snapped_vertex

namespace host {
namespace {

using core::Result;
using core::Status;
using core::Triangle;
using core::Vertex;

// A backslash at a line's end, with at most blanks behind it.
constexpr std::size_t kJoinBytes = 64;

class ObjReader : public TriangleSource {
 public:
  explicit ObjReader(InputFile file) : text_(std::move(file)) {}

  [[nodiscard]] std::string format() const override { return "OBJ"; }

  [[nodiscard]] bool read_in(double unit_mm) override {
    unit_mm_ = unit_mm;
    return true;
  }

  [[nodiscard]] Result<std::optional<Triangle>> next() override {
    while (true) {
      if (corners_ >= 2) {
        Result<std::optional<Triangle>> triangle = next_of_fan();
        if (!triangle.ok() || triangle.value()) return triangle;
        continue;
      }
      if (text_.skip_blanks() == TextScanner::kEnd) return end();
      const std::string_view word = text_.word("\\");
      if (word == "v") {
        if (Status read = vertex(); !read.ok()) return read.error();
      } else if (word == "f" || word == "fo") {
        if (Status read = start_face(); !read.ok()) return read.error();
      } else {
        skip_line();
      }
    }
  }

 private:
  // A triangle of a face that comes before its vertices.
  struct Waiting {
    std::array<std::int64_t, 3> corners{};
    std::int64_t line = 0;
  };

  // After the last line: the triangles that had to wait, then nullopt.
  [[nodiscard]] Result<std::optional<Triangle>> end() {
    if (text_.failed()) return text_.bad("");
    while (next_waiting_ < waiting_.size()) {
      const Waiting waiting = waiting_.at(next_waiting_++);
      for (const std::int64_t corner : waiting.corners) {
        if (known(corner)) continue;
        return core::Error{core::ErrorCode::kBadPart,
                           text_.name() + ": line " + std::to_string(waiting.line) + ": vertex " +
                               std::to_string(corner + 1) + " of " +
                               std::to_string(vertices_.size()) +
                               ": there is none; export the part again"};
      }
      ++facets_;
      return std::optional<Triangle>(triangle_of(waiting.corners));
    }
    if (facets_ == 0) return text_.bad("there is no face in the file; export the part again");
    if (left_out_ > 0 && !std::exchange(told_, true)) {
      warnings_.push_back(text_.name() + ": " + std::to_string(left_out_) +
                          (left_out_ == 1 ? " face" : " faces") +
                          " of fewer than three corners left out, in line " +
                          std::to_string(left_out_line_) + (left_out_ == 1 ? "" : " first"));
    }
    return std::optional<Triangle>();
  }

  // Skips blanks within a line of a vertex or a face, and joins the next line at a backslash.
  // Returns peek(), which is a backslash if that is elsewhere in the line.
  int skip_spaces() {
    while (true) {
      const int c = text_.peek();
      if (c == '\\' && joins_lines()) {
        take_line_end();
      } else if (is_space(c)) {
        text_.take();
      } else {
        return c;
      }
    }
  }

  // Reads a backslash that only blanks follow, up to the line's end.
  [[nodiscard]] bool joins_lines() {
    const std::string_view ahead = text_.lookahead(kJoinBytes).substr(1);
    const std::size_t at = ahead.find_first_not_of(" \t\f\v");
    if (at != std::string_view::npos && ahead[at] != '\n' && ahead[at] != '\r') return false;
    text_.take();
    return true;
  }

  // Skips blanks and one line end; an empty line joins nothing.
  void take_line_end() {
    while (is_space(text_.peek())) text_.take();
    const int c = text_.peek();
    if (c == '\r' || c == '\n') text_.take();
    if (c == '\r' && text_.peek() == '\n') text_.take();
  }

  [[nodiscard]] static bool is_space(int c) {
    return c == ' ' || c == '\t' || c == '\f' || c == '\v';
  }

  [[nodiscard]] static bool ends_line(int c) {
    return c == TextScanner::kEnd || c == '\n' || c == '\r' || c == '#';
  }

  // Comments and unknown lines are never joined, even after a backslash: Windows paths end in one.
  void skip_line() {
    for (int c = text_.peek(); c != TextScanner::kEnd && c != '\n' && c != '\r'; c = text_.peek()) {
      text_.take();
    }
  }

  [[nodiscard]] Status vertex() {
    PointMm mm{};
    for (double& coordinate : mm) {
      const std::string_view word =
          ends_line(skip_spaces()) ? std::string_view() : text_.word("\\");
      const std::optional<double> value = parse_real(word);
      if (!value) return text_.unexpected(word, "a coordinate");
      coordinate = *value * unit_mm_;
    }
    const std::optional<Vertex> vertex = snapped_vertex(mm);
    if (!vertex) return text_.bad(vertex_too_far(mm));
    // Skips weights and colours, also in a joined line.
    while (!ends_line(skip_spaces())) text_.take();
    skip_line();
    return vertices_.push_back(*vertex);
  }

  // The next corner of the face, counted from 0; nullopt at the line's end.
  [[nodiscard]] Result<std::optional<std::int64_t>> corner() {
    if (ends_line(skip_spaces())) {
      skip_line();
      return std::optional<std::int64_t>();
    }
    const std::string_view word = text_.word("\\");
    const std::optional<std::int64_t> number = parse_integer(word.substr(0, word.find('/')));
    if (!number) return text_.unexpected(word, "a vertex's number");
    const auto count = static_cast<std::int64_t>(vertices_.size());
    const std::int64_t index = *number < 0 ? count + *number : *number - 1;
    if (index < 0 || *number == 0) {
      return text_.bad("vertex " + std::to_string(*number) + " of " + std::to_string(count) +
                       " so far: there is none; export the part again");
    }
    return std::optional<std::int64_t>(index);
  }

  [[nodiscard]] Status start_face() {
    corners_ = 0;
    face_line_ = text_.line();
    for (std::int64_t* into : {&first_, &last_}) {
      const Result<std::optional<std::int64_t>> read = corner();
      if (!read.ok()) return read.error();
      if (!read.value()) {
        leave_face_out();
        return {};
      }
      *into = *read.value();
      ++corners_;
    }
    return {};
  }

  void leave_face_out() {
    corners_ = 0;
    if (left_out_++ == 0) left_out_line_ = face_line_;
  }

  [[nodiscard]] Result<std::optional<Triangle>> next_of_fan() {
    const Result<std::optional<std::int64_t>> read = corner();
    if (!read.ok()) return read.error();
    if (!read.value()) {
      if (corners_ == 2) leave_face_out();
      corners_ = 0;
      return std::optional<Triangle>();
    }
    const std::array<std::int64_t, 3> corners{first_, last_, *read.value()};
    last_ = *read.value();
    ++corners_;
    if (!std::all_of(corners.begin(), corners.end(), [this](std::int64_t i) { return known(i); })) {
      if (Status kept = waiting_.push_back({corners, face_line_}); !kept.ok()) return kept.error();
      return std::optional<Triangle>();
    }
    ++facets_;
    return std::optional<Triangle>(triangle_of(corners));
  }

  [[nodiscard]] bool known(std::int64_t corner) const {
    return static_cast<std::size_t>(corner) < vertices_.size();
  }

  [[nodiscard]] Triangle triangle_of(const std::array<std::int64_t, 3>& corners) const {
    Triangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.corners[i] = vertices_.at(static_cast<std::size_t>(corners[i]));
    }
    return triangle;
  }

  double unit_mm_ = 1;
  TextScanner text_;
  MappedArray<Vertex> vertices_;
  MappedArray<Waiting> waiting_;
  std::size_t next_waiting_ = 0;
  // The face that is being cut: corners read so far, the first and the last of them.
  std::int64_t corners_ = 0;
  std::int64_t first_ = 0;
  std::int64_t last_ = 0;
  std::int64_t face_line_ = 0;
  std::int64_t left_out_ = 0;
  std::int64_t left_out_line_ = 0;
  bool told_ = false;
};

}  // namespace

Result<std::unique_ptr<TriangleSource>> open_obj(InputFile file) {
  return std::unique_ptr<TriangleSource>(std::make_unique<ObjReader>(std::move(file)));
}

}  // namespace host
