#include "host/formats/obj_reader.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "host/formats/number_text.h"   // parse_real
#include "host/formats/text_scanner.h"  // TextScanner
#include "host/formats/vertex_snap.h"   // snapped_vertex
#include "host/part/mapped_array.h"     // MappedArray

namespace host {
namespace {

using core::Result;
using core::Status;
using core::Triangle;
using core::Vertex;

class ObjReader : public TriangleSource {
 public:
  explicit ObjReader(InputFile file) : text_(std::move(file)) {}

  [[nodiscard]] std::string format() const override { return "OBJ"; }

  [[nodiscard]] Result<std::optional<Triangle>> next() override {
    while (true) {
      if (corners_ >= 2) {
        Result<std::optional<Triangle>> triangle = next_of_fan();
        if (!triangle.ok() || triangle.value()) return triangle;
      }
      if (text_.skip_blanks() == TextScanner::kEnd) return end();
      const std::string_view word = text_.word();
      if (word == "v") {
        if (Status read = vertex(); !read.ok()) return read.error();
      } else if (word == "f") {
        if (Status read = begin_face(); !read.ok()) return read.error();
      } else {
        skip_line();
      }
    }
  }

 private:
  [[nodiscard]] Result<std::optional<Triangle>> end() {
    if (text_.failed()) return text_.bad("");
    if (facets_ == 0) return text_.bad("there is no face in the file; export the part again");
    return std::optional<Triangle>();
  }

  // Blanks within a line; a backslash at its end joins the next one.
  int skip_spaces() {
    while (true) {
      const int c = text_.peek();
      if (c == '\\') {
        text_.take();
        text_.skip_blanks();
      } else if (c == ' ' || c == '\t' || c == '\f' || c == '\v') {
        text_.take();
      } else {
        return c;
      }
    }
  }

  [[nodiscard]] static bool ends_line(int c) {
    return c == TextScanner::kEnd || c == '\n' || c == '\r' || c == '#';
  }

  void skip_line() {
    int last = 0;
    for (int c = text_.peek(); c != TextScanner::kEnd; c = text_.peek()) {
      if ((c == '\n' || c == '\r') && last != '\\') return;
      last = c;
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
      coordinate = *value;
    }
    const std::optional<Vertex> vertex = snapped_vertex(mm);
    if (!vertex) return text_.bad(vertex_too_far(mm));
    skip_line();
    return vertices_.push_back(*vertex);
  }

  // The next corner of the face; nothing at the line's end.
  [[nodiscard]] Result<std::optional<Vertex>> corner() {
    if (ends_line(skip_spaces())) {
      skip_line();
      return std::optional<Vertex>();
    }
    const std::string_view word = text_.word("\\");
    const std::optional<std::int64_t> number = parse_integer(word.substr(0, word.find('/')));
    if (!number) return text_.unexpected(word, "a vertex's number");
    const auto count = static_cast<std::int64_t>(vertices_.size());
    const std::int64_t index = *number < 0 ? count + *number : *number - 1;
    if (index < 0 || index >= count || *number == 0) {
      return text_.bad("vertex " + std::to_string(*number) + " of " + std::to_string(count) +
                       " so far: there is none; export the part again");
    }
    return std::optional<Vertex>(vertices_.at(static_cast<std::size_t>(index)));
  }

  [[nodiscard]] Status begin_face() {
    corners_ = 0;
    for (Vertex* into : {&first_, &last_}) {
      const Result<std::optional<Vertex>> read = corner();
      if (!read.ok()) return read.error();
      if (!read.value()) return text_.bad("a face of fewer than three corners; repair the mesh");
      *into = *read.value();
      ++corners_;
    }
    return {};
  }

  [[nodiscard]] Result<std::optional<Triangle>> next_of_fan() {
    const Result<std::optional<Vertex>> read = corner();
    if (!read.ok()) return read.error();
    if (!read.value()) {
      const bool whole = corners_ > 2;
      corners_ = 0;
      if (!whole) return text_.bad("a face of fewer than three corners; repair the mesh");
      return std::optional<Triangle>();
    }
    Triangle triangle{{first_, last_, *read.value()}};
    last_ = *read.value();
    ++corners_;
    ++facets_;
    return std::optional<Triangle>(triangle);
  }

  TextScanner text_;
  MappedArray<Vertex> vertices_;
  // Of the face that is being cut: how many corners were read, the first and the last of them.
  std::int64_t corners_ = 0;
  Vertex first_;
  Vertex last_;
};

}  // namespace

Result<std::unique_ptr<TriangleSource>> open_obj(InputFile file) {
  return std::unique_ptr<TriangleSource>(std::make_unique<ObjReader>(std::move(file)));
}

}  // namespace host
