#include <fast_float/fast_float.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "host/formats/stl_kinds.h"
#include "host/system/text.h"  // lower_case

namespace host {
namespace {

using core::Error;
using core::Result;

// STL has no longer words; names are skipped unread.
constexpr std::size_t kWordMax = 256;
// "normal" and its numbers, which are ignored.
constexpr int kNormalWordsMax = 4;

bool is_line_end(char c) { return c == '\n' || c == '\r'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v' || is_line_end(c); }

bool is_word(std::string_view text, std::string_view word) {
  return std::equal(text.begin(), text.end(), word.begin(), word.end(),
                    [](char a, char b) { return lower_case(a) == b; });
}

std::string_view without_mark(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

// Removes the first word of `text` and returns it; empty at its end.
std::string_view take_word(std::string_view& text) {
  const auto* begin = std::find_if_not(text.begin(), text.end(), is_blank);
  const auto* end = std::find_if(begin, text.end(), is_blank);
  text.remove_prefix(static_cast<std::size_t>(end - text.begin()));
  return {begin, static_cast<std::size_t>(end - begin)};
}

bool has_control_bytes(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x20 && !is_blank(c); });
}

// Words of a text with their lines.
class Words {
 public:
  explicit Words(InputFile& file) : file_(file) {}

  [[nodiscard]] std::int64_t line() const { return line_; }

  // The next word, valid until the next call; empty at the end of the file.
  [[nodiscard]] Result<std::string_view> next() {
    if (core::Status skipped = skip_while(is_blank); !skipped.ok()) return skipped.error();
    const Result<std::string_view> window = file_.window(kWordMax + 1);
    if (!window.ok()) return window.error();
    const std::string_view text = window.value().substr(0, kWordMax);
    const auto* end = std::find_if(text.begin(), text.end(), is_blank);
    const std::string_view word(text.begin(), static_cast<std::size_t>(end - text.begin()));
    file_.skip(word.size());
    after_return_ = after_return_ && word.empty();
    return word;
  }

  // Skips to the line's end, however long the line is.
  [[nodiscard]] core::Status skip_line() {
    return skip_while([](char c) { return !is_line_end(c); });
  }

 private:
  template <typename Kind>
  [[nodiscard]] core::Status skip_while(Kind kind) {
    while (true) {
      const Result<std::string_view> window = file_.window(1);
      if (!window.ok()) return window.error();
      const std::string_view text = window.value();
      const auto* end = std::find_if_not(text.begin(), text.end(), kind);
      for (const auto* c = text.begin(); c != end; ++c) count_line(*c);
      const std::size_t count = static_cast<std::size_t>(end - text.begin());
      const bool more = count == text.size() && count > 0;
      file_.skip(count);
      if (!more) return {};
    }
  }

  void count_line(char c) {
    if (c == '\r' || (c == '\n' && !after_return_)) ++line_;
    after_return_ = c == '\r';
  }

  InputFile& file_;
  std::int64_t line_ = 1;
  bool after_return_ = false;  // a line feed here belongs to the return before it
};

class TextStlReader : public StlReader {
 public:
  explicit TextStlReader(InputFile file) : StlReader(std::move(file)), words_(file_) {}

  [[nodiscard]] std::string format() const override { return "ASCII STL"; }

  [[nodiscard]] Result<std::optional<core::Triangle>> next() override {
    while (true) {
      const Result<std::string_view> word = words_.next();
      if (!word.ok()) return word.error();
      if (word.value().empty()) return end();
      const bool starts = is_word(word.value(), "solid"), ends = is_word(word.value(), "endsolid");
      const bool facet_starts = is_word(word.value(), "facet");
      if (starts || (ends && in_solid_)) {
        if (starts && in_solid_) ++unended_;
        in_solid_ = starts;
        ended_once_ = ended_once_ || ends;
        if (core::Status skipped = words_.skip_line(); !skipped.ok()) return skipped.error();
      } else if (in_solid_ && facet_starts) {
        return facet();
      } else if (!in_solid_ && ended_once_ && !facet_starts) {
        if (text_line_ == 0) text_line_ = words_.line();
        if (core::Status skipped = words_.skip_line(); !skipped.ok()) return skipped.error();
      } else {
        return unexpected(word.value(), in_solid_ ? "'facet' or 'endsolid'" : "'solid'");
      }
    }
  }

 private:
  [[nodiscard]] std::string place() const {
    return "facet " + std::to_string(facets_ + 1) + " (line " + std::to_string(words_.line()) + ")";
  }

  // `word`: the last of next().
  [[nodiscard]] Error unexpected(std::string_view word, const std::string& wanted) {
    std::string shown(word.substr(0, 40));
    std::replace_if(
        shown.begin(), shown.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, '?');
    const Result<std::string_view> rest = file_.window(1);
    if (!rest.ok()) return rest.error();
    const std::string should_be = " where " + wanted + " should be";
    if (!rest.value().empty()) {
      return bad_part(place(), "'" + shown + "'" + should_be + "; repair the file");
    }
    return bad_part(place(), "the file ends" + (word.empty() ? "" : " with '" + shown + "'") +
                                 should_be + ": it is cut short; copy or export it again");
  }

  [[nodiscard]] Result<std::optional<core::Triangle>> end() {
    if (facets_ == 0 && in_solid_) return unexpected({}, "'endsolid'");
    if (facets_ == 0) {
      return bad_part("line " + std::to_string(words_.line()),
                      "there is no facet in the file; export the part again");
    }
    if (std::exchange(told_, true)) return std::optional<core::Triangle>();
    if (in_solid_) {
      doubt_ = "the file ends without 'endsolid', after " + std::to_string(facets_) + " facets";
    } else if (unended_ > 0) {
      warnings_.push_back(file_.name() + ": 'endsolid' is missing before another 'solid'");
    }
    if (text_line_ > 0) {
      warnings_.push_back(file_.name() + ": what stands behind 'endsolid' was left out (line " +
                          std::to_string(text_line_) + ")");
    }
    return std::optional<core::Triangle>();
  }

  [[nodiscard]] core::Status expect(std::string_view wanted) {
    const Result<std::string_view> word = words_.next();
    if (!word.ok()) return word.error();
    if (is_word(word.value(), wanted)) return {};
    return unexpected(word.value(), "'" + std::string(wanted) + "'");
  }

  // Skips the normal, up to "outer": some writers put nan or nothing there.
  [[nodiscard]] core::Status skip_normal() {
    for (int i = 0; i <= kNormalWordsMax; ++i) {
      const Result<std::string_view> word = words_.next();
      if (!word.ok()) return word.error();
      if (is_word(word.value(), "outer")) return {};
      if (word.value().empty() || i == kNormalWordsMax) {
        return unexpected(word.value(), "'outer loop'");
      }
    }
    return {};
  }

  [[nodiscard]] Result<double> number() {
    const Result<std::string_view> word = words_.next();
    if (!word.ok()) return word.error();
    std::string_view digits = word.value();
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0;
    const auto [end, error] =
        fast_float::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::invalid_argument || end != digits.data() + digits.size() ||
        digits.empty()) {
      return unexpected(word.value(), "a number");
    }
    return value;
  }

  [[nodiscard]] Result<std::optional<core::Triangle>> facet() {
    if (core::Status normal = skip_normal(); !normal.ok()) return normal.error();
    if (core::Status loop = expect("loop"); !loop.ok()) return loop.error();
    Corners corners{};
    for (auto& corner : corners) {
      if (core::Status vertex = expect("vertex"); !vertex.ok()) return vertex.error();
      for (double& coordinate : corner) {
        Result<double> read = number();
        if (!read.ok()) return read.error();
        coordinate = read.value();
      }
    }
    const std::optional<core::Triangle> triangle = snapped(corners);
    if (!triangle) return not_snapped(corners, place());
    if (core::Status end = expect("endloop"); !end.ok()) return end.error();
    if (core::Status end = expect("endfacet"); !end.ok()) return end.error();
    ++facets_;
    return std::optional<core::Triangle>(triangle.value());
  }

  Words words_;
  bool in_solid_ = false;
  bool ended_once_ = false;     // a solid has ended: other text may follow
  std::int64_t unended_ = 0;    // solids without an end before the next one
  std::int64_t text_line_ = 0;  // the first line after a solid that is no STL
  bool told_ = false;
};

}  // namespace

StlText text_kind(std::string_view window) {
  std::string_view text = without_mark(window);
  const bool solid = is_word(take_word(text), "solid");
  if (solid) {
    const auto* line_end = std::find_if(text.begin(), text.end(), is_line_end);
    std::string_view rest(line_end, static_cast<std::size_t>(text.end() - line_end));
    const std::string_view word = take_word(rest);
    // The window ends here: both kinds are possible, and its last word may be incomplete.
    const bool cut_off = rest.empty() && !has_control_bytes(window);
    if (is_word(word, "facet") || is_word(word, "endsolid") || cut_off) return StlText::kStl;
  }
  if (has_control_bytes(window)) return StlText::kNone;
  return solid ? StlText::kNotFacets : StlText::kOther;
}

Result<std::unique_ptr<StlReader>> open_text_stl(InputFile file) {
  const Result<std::string_view> window = file.window(4);
  if (!window.ok()) return window.error();
  file.skip(window.value().size() - without_mark(window.value()).size());
  return std::unique_ptr<StlReader>(std::make_unique<TextStlReader>(std::move(file)));
}

}  // namespace host
