// Lines out of pieces of text: every end of line, cut anywhere, long lines, places to go on from.
#include "host/gcode/gcode_lines.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <random>
#include <string>
#include <vector>

#include "host/gcode/gcode_text.h"

using host::GcodeLine;
using host::GcodeLines;
using host::TextPlace;

namespace {

// Gives the text in the pieces that a test wants.
class PieceText final : public host::GcodeText {
 public:
  PieceText(std::string text, std::vector<std::size_t> ends)
      : text_(std::move(text)), ends_(std::move(ends)) {
    ends_.push_back(text_.size());
  }

  core::Result<std::string_view> next() override {
    from_ = to_;
    while (to_ == from_ && next_ < ends_.size()) to_ = std::max(to_, ends_[next_++]);
    return std::string_view(text_).substr(from_, to_ - from_);
  }
  core::Status go_to(const TextPlace& place) override {
    from_ = to_ = static_cast<std::size_t>(place.block);
    next_ = ends_.size() - 1;
    return {};
  }
  [[nodiscard]] TextPlace place_in(std::size_t byte) const override {
    return {static_cast<std::int64_t>(from_ + byte), 0};
  }
  [[nodiscard]] const std::string& metadata() const override { return none_; }
  [[nodiscard]] std::int64_t bytes_read() const override { return 0; }
  [[nodiscard]] std::uint64_t hash() const override { return 0; }

 private:
  std::string text_;
  std::vector<std::size_t> ends_;
  std::size_t next_ = 0;
  std::size_t from_ = 0;
  std::size_t to_ = 0;
  std::string none_;
};

struct OwnLine {
  std::string text, comment;
  std::int64_t number = 0;
  TextPlace place;
};

std::vector<OwnLine> lines_of(host::GcodeText& text, std::int64_t before = 0) {
  GcodeLines lines(text, before);
  std::vector<OwnLine> all;
  while (true) {
    const core::Result<std::optional<GcodeLine>> line = lines.next();
    if (!line.ok()) FAIL(line.error().message);
    if (!line.value()) return all;
    all.push_back({std::string(line.value()->text), std::string(line.value()->comment),
                   line.value()->number, line.value()->place});
  }
}

}  // namespace

TEST_CASE("each end of line ends one line, wherever pieces are cut") {
  const std::vector<std::string> whole = {"G1 X5 ; five", "", "M117 hello", "; only this", "G28"};
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const std::string& line : whole) text += line + end;
    const std::uint64_t seed = std::random_device()();
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 300; ++i) {
      std::vector<std::size_t> cuts;
      for (std::size_t at = 0; at < text.size(); at += 1 + random() % 9) cuts.push_back(at);
      PieceText pieces(text, cuts);
      const std::vector<OwnLine> lines = lines_of(pieces);
      REQUIRE_EQ(lines.size(), whole.size());
      for (std::size_t n = 0; n < lines.size(); ++n) {
        const std::string all =
            lines[n].text + (lines[n].comment.empty() ? "" : ";" + lines[n].comment);
        CHECK_EQ(all, whole[n]);
        CHECK_EQ(lines[n].number, static_cast<std::int64_t>(n) + 1);
      }
      // From the place of any line on, the rest comes again.
      const std::size_t from = random() % lines.size();
      CHECK(pieces.go_to(lines[from].place).ok());
      const std::vector<OwnLine> rest = lines_of(pieces, static_cast<std::int64_t>(from));
      REQUIRE_EQ(rest.size(), whole.size() - from);
      CHECK_EQ(rest.front().text, lines[from].text);
      CHECK_EQ(rest.back().number, lines.back().number);
    }
  }
}

TEST_CASE("a last line needs no end, a mark of UTF-8 is no text") {
  PieceText text("\xEF\xBB\xBFG28\nG1 X1", {2});
  const std::vector<OwnLine> lines = lines_of(text);
  REQUIRE_EQ(lines.size(), 2);
  CHECK_EQ(lines[1].text, "G1 X1");
  PieceText empty("", {});
  CHECK(lines_of(empty).empty());
}

TEST_CASE("a comment may be as long as it likes, a line may not; no zeros") {
  const std::string long_comment = "G28 ;" + std::string(300'000, 'c') + "\nG1 X1\n";
  PieceText fine(long_comment, {70'000, 140'000});
  const std::vector<OwnLine> lines = lines_of(fine);
  REQUIRE_EQ(lines.size(), 2);
  CHECK_EQ(lines[0].comment.size(), host::kCommentBytesMax);
  for (const std::string& bad :
       {"G28\nM117 " + std::string(2'000, 'x') + "\n", "G28\n" + std::string("G1 X\0 5\n", 8)}) {
    PieceText text(bad, {});
    GcodeLines reader(text);
    CHECK(reader.next().ok());
    const auto failed = reader.next();
    REQUIRE_FALSE(failed.ok());
    CHECK_NE(failed.error().message.find("line 2: "), std::string::npos);
  }
}
