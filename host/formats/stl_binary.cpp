#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "host/formats/little_endian.h"  // float_at, u32_at
#include "host/formats/stl_kinds.h"

namespace host {
namespace {

using core::Result;

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kFacetBytes = 50;
constexpr std::size_t kNormalBytes = 12;
// A larger number is no count: writers that never fill it in leave -1 or the like.
constexpr std::uint32_t kCountMax = 0x7FFFFFFE;

class BinaryStlReader : public StlReader {
 public:
  // `there`: facets that fill the file exactly, if known; they have precedence over the head.
  BinaryStlReader(InputFile file, std::uint32_t count, std::optional<std::int64_t> there)
      : StlReader(std::move(file)), count_(count), to_the_end_(count == 0 || there > count) {}

  [[nodiscard]] std::string format() const override { return "binary STL"; }

  [[nodiscard]] Result<std::optional<core::Triangle>> next() override {
    if (ended_) return std::optional<core::Triangle>();
    if (!to_the_end_ && facets_ == count_) return end_with_rest();
    const Result<std::string_view> window = file_.window(kFacetBytes);
    if (!window.ok()) return window.error();
    const std::string_view bytes = window.value();
    if (bytes.empty()) return end_without_rest();
    if (bytes.size() < kFacetBytes) {
      return bad_part(place(), "the file ends after " + std::to_string(bytes.size()) +
                                   " of the facet's 50 bytes: it is cut short; copy or export it "
                                   "again");
    }
    const Corners corners = corners_at(bytes.data());
    const std::optional<core::Triangle> triangle = snapped(corners);
    if (!triangle) return not_snapped(corners, place());
    file_.skip(kFacetBytes);
    ++facets_;
    return triangle;
  }

  // Whole facets at once, out of what has been read already.
  [[nodiscard]] core::Status next_some(std::size_t most,
                                       std::vector<core::Triangle>& into) override {
    while (most > 0) {
      std::size_t whole = 0;
      if (!ended_ && (to_the_end_ || facets_ < count_)) {
        const Result<std::string_view> window = file_.window(kFacetBytes);
        if (!window.ok()) return window.error();
        whole = std::min(most, window.value().size() / kFacetBytes);
        if (!to_the_end_) whole = std::min(whole, static_cast<std::size_t>(count_ - facets_));
        whole = take(window.value().data(), whole, into);
      }
      // What is no whole facet, the end, and errors.
      if (whole == 0) return StlReader::next_some(1, into);
      most -= whole;
    }
    return {};
  }

 private:
  static Corners corners_at(const char* facet) {
    Corners corners{};
    for (std::size_t i = 0; i < 9; ++i) {
      corners[i / 3][i % 3] = float_at(facet + kNormalBytes + 4 * i);
    }
    return corners;
  }

  // Returns how many there are before one that is no triangle.
  std::size_t take(const char* facets, std::size_t count, std::vector<core::Triangle>& into) {
    std::size_t taken = 0;
    for (; taken < count; ++taken) {
      const std::optional<core::Triangle> triangle =
          snapped(corners_at(facets + taken * kFacetBytes));
      if (!triangle) break;
      into.push_back(*triangle);
    }
    file_.skip(taken * kFacetBytes);
    facets_ += static_cast<std::int64_t>(taken);
    return taken;
  }

  [[nodiscard]] std::string place() const {
    return "facet " + std::to_string(facets_ + 1) + " (byte " + std::to_string(file_.position()) +
           ")";
  }

  [[nodiscard]] Result<std::optional<core::Triangle>> end_without_rest() {
    ended_ = true;
    if (facets_ == 0) {
      return bad_part("byte 84", "there is no facet in the file; export the part again");
    }
    const std::string what = "the header counts " + std::to_string(count_) +
                             " facets, the file has " + std::to_string(facets_);
    if (count_ > facets_ && count_ <= kCountMax) {
      doubt_ = what;
    } else {
      warnings_.push_back(file_.name() + ": " + what + "; all that are there were taken");
    }
    return std::optional<core::Triangle>();
  }

  [[nodiscard]] Result<std::optional<core::Triangle>> end_with_rest() {
    ended_ = true;
    const Result<std::string_view> rest = file_.window(1);
    if (!rest.ok()) return rest.error();
    if (!rest.value().empty()) {
      warnings_.push_back(file_.name() + ": the file goes on after the " + std::to_string(count_) +
                          " facets that its header counts (byte " +
                          std::to_string(file_.position()) + "); the rest was not taken");
    }
    return std::optional<core::Triangle>();
  }

  std::uint32_t count_;
  bool to_the_end_;  // the count is 0: the writer never filled it in
  bool ended_ = false;
};

// Facets in a file of this size; nullopt if the size is not known or the number is not whole.
std::optional<std::int64_t> facets_in(const InputFile& file) {
  const std::optional<std::int64_t> size = file.size();
  constexpr auto kHead = static_cast<std::int64_t>(kHeaderBytes);
  constexpr auto kFacet = static_cast<std::int64_t>(kFacetBytes);
  if (!size || *size < kHead || (*size - kHead) % kFacet != 0) return std::nullopt;
  return (*size - kHead) / kFacet;
}

}  // namespace

bool is_binary_stl(const InputFile& file, std::string_view start) {
  return start.size() >= kHeaderBytes && facets_in(file) == u32_at(start.data() + kHeaderBytes - 4);
}

Result<std::unique_ptr<StlReader>> open_binary_stl(InputFile file) {
  const Result<std::string_view> window = file.window(kHeaderBytes);
  if (!window.ok()) return window.error();
  if (window.value().size() < kHeaderBytes) {
    return core::Error{core::ErrorCode::kBadPart,
                       file.name() + ": byte " + std::to_string(window.value().size()) +
                           ": the file ends within the 84 bytes of a binary STL's header; it is "
                           "cut short, or no STL"};
  }
  const std::uint32_t count = u32_at(window.value().data() + kHeaderBytes - 4);
  const std::optional<std::int64_t> there = facets_in(file);
  file.skip(kHeaderBytes);
  return std::unique_ptr<StlReader>(
      std::make_unique<BinaryStlReader>(std::move(file), count, there));
}

}  // namespace host
