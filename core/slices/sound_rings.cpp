#include "core/slices/sound_rings.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace core {
namespace {

using Index = std::uint32_t;
constexpr Index kNone = std::numeric_limits<Index>::max();

// Slots of the hash table for each segment, at least.
constexpr std::size_t kSlotsEach = 2;

class SoundChains {
 public:
  // Whether all segments make rings as sound_rings() says.
  [[nodiscard]] bool find(const std::vector<Segment>& segments) {
    return enter(segments) && join(segments) && go_around(segments);
  }

  [[nodiscard]] std::vector<Ring> rings(const std::vector<Segment>& segments,
                                        const OnOneLine& on_one_line) const {
    std::vector<Ring> rings(chains_.size());
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      write(chains_[i], segments, on_one_line, rings[i]);
    }
    return rings;
  }

 private:
  // Segments in order_, which follow one another.
  struct Chain {
    std::size_t first = 0;
    std::size_t end = 0;
    std::size_t least = 0;  // the one that leaves the least point
    Point least_point;
  };

  [[nodiscard]] std::size_t slot_of(Point point) const {
    return static_cast<std::size_t>(hash_of(point) >> shift_);
  }

  // By their starts; false where two are at one point.
  [[nodiscard]] bool enter(const std::vector<Segment>& segments) {
    if (segments.size() >= kNone / kSlotsEach) return false;
    const std::size_t slots = std::bit_ceil(std::max<std::size_t>(2, kSlotsEach * segments.size()));
    shift_ = 64 - std::countr_zero(slots);
    mask_ = slots - 1;
    table_.assign(slots, kNone);
    for (Index i = 0; i < segments.size(); ++i) {
      const Segment& segment = segments[i];
      if (segment.from == segment.to) continue;
      std::size_t slot = slot_of(segment.from);
      for (; table_[slot] != kNone; slot = (slot + 1) & mask_) {
        if (segments[table_[slot]].from == segment.from) return false;
      }
      table_[slot] = i;
    }
    return true;
  }

  // Each to the one that leaves its end; false where there is none.
  [[nodiscard]] bool join(const std::vector<Segment>& segments) {
    next_.assign(segments.size(), kNone);
    for (Index i = 0; i < segments.size(); ++i) {
      const Segment& segment = segments[i];
      if (segment.from == segment.to) continue;
      std::size_t slot = slot_of(segment.to);
      while (table_[slot] != kNone && segments[table_[slot]].from != segment.to) {
        slot = (slot + 1) & mask_;
      }
      if (table_[slot] == kNone) return false;
      next_[i] = table_[slot];
    }
    return true;
  }

  // False where two come to one point, or two segments make a ring.
  [[nodiscard]] bool go_around(const std::vector<Segment>& segments) {
    chains_.clear();
    order_.clear();
    order_.reserve(segments.size());
    for (Index start = 0; start < segments.size(); ++start) {
      if (next_[start] == kNone) continue;
      Chain chain{order_.size(), 0, order_.size(), segments[start].from};
      Index i = start;
      do {
        if (segments[i].from < chain.least_point) {
          chain.least = order_.size();
          chain.least_point = segments[i].from;
        }
        order_.push_back(i);
        i = std::exchange(next_[i], kNone);
      } while (next_[i] != kNone);
      chain.end = order_.size();
      if (i != start || chain.end - chain.first < 3) return false;
      chains_.push_back(chain);
    }
    std::sort(chains_.begin(), chains_.end(),
              [](const Chain& a, const Chain& b) { return a.least_point < b.least_point; });
    return true;
  }

  // From the least point on, without points between two segments on one line.
  void write(const Chain& chain, const std::vector<Segment>& segments, const OnOneLine& on_one_line,
             Ring& ring) const {
    ring.reserve(chain.end - chain.first);
    Index before = order_[(chain.least == chain.first ? chain.end : chain.least) - 1];
    const auto write_part = [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) {
        const Index after = order_[i];
        if (!on_one_line(before, after)) ring.push_back(segments[after].from);
        before = after;
      }
    };
    write_part(chain.least, chain.end);
    write_part(chain.first, chain.least);
  }

  std::vector<Index> table_;  // by slot, the segment that starts there
  int shift_ = 0;
  std::size_t mask_ = 0;
  std::vector<Index> next_;  // by segment; kNone once it is in order_
  std::vector<Index> order_;
  std::vector<Chain> chains_;
};

}  // namespace

std::optional<std::vector<Ring>> sound_rings(const std::vector<Segment>& segments,
                                             const OnOneLine& on_one_line) {
  thread_local SoundChains chains;
  if (!chains.find(segments)) return std::nullopt;
  return chains.rings(segments, on_one_line);
}

}  // namespace core
