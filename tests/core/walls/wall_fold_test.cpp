#include "core/walls/wall_fold.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "core/limits.h"
#include "tests/support/paper_formula.h"

namespace {

// 64 columns of a part at once: bit b of a mask says whether the layer is there in column b.
using Mask = std::uint64_t;
using MaskFold = core::WallFold<int, Mask, std::bit_and<>>;

struct MaskOperations {
  static Mask unite(Mask a, Mask b) { return a | b; }
  static Mask intersect(Mask a, Mask b) { return a & b; }
  static Mask subtract(Mask a, Mask b) { return a & ~b; }
};

struct Part {
  std::vector<Mask> slices;
  std::vector<Mask> inners;  // inners[n] within slices[n]
};

// Columns that start somewhere and go on for a while, with a wall here and there. One in `rarity`
// bits changes from layer to layer.
Part random_part(int height, unsigned rarity, std::mt19937_64& random) {
  const auto rare = [&] {
    Mask mask = 0;
    for (int bit = 0; bit < 64; ++bit) {
      mask |= Mask{random() % rarity == 0 ? 1u : 0u} << bit;
    }
    return mask;
  };
  Part part;
  Mask slice = ~rare();
  for (int n = 0; n < height; ++n) {
    slice ^= rare();
    part.slices.push_back(slice);
    part.inners.push_back(slice & ~rare());
  }
  return part;
}

struct Run {
  std::vector<Mask> loose;
  std::vector<int> left_at;  // how many layers had been pushed when layer n left
  int finishes = 0;
};

Run run(const Part& part, int t) {
  MaskFold fold(t);
  Run result;
  int pushed = 0;
  const auto take = [&](const std::optional<MaskFold::Settled>& settled) {
    if (!settled.has_value()) return false;
    REQUIRE_EQ(settled->item, static_cast<int>(result.loose.size()));
    result.loose.push_back(settled->shared.value_or(0));
    result.left_at.push_back(pushed);
    return true;
  };
  const std::size_t window = 2 * static_cast<std::size_t>(t) + 1;
  for (const Mask inner : part.inners) {
    const auto settled = fold.push(pushed, inner);
    ++pushed;
    take(settled);
    REQUIRE_LE(fold.operations(), std::bit_width(window - 1));
    REQUIRE_LE(fold.items_held(), static_cast<std::size_t>(t));
    REQUIRE_LE(fold.items_held_peak(), static_cast<std::size_t>(t) + 1);
    REQUIRE_LE(fold.partials_held(), 2 * static_cast<std::size_t>(t));
  }
  while (take(fold.finish())) ++result.finishes;
  REQUIRE_EQ(fold.items_held(), 0);
  REQUIRE_FALSE(fold.finish().has_value());
  return result;
}

void check_against_paper(const Part& part, int t) {
  const Run result = run(part, t);
  const int height = static_cast<int>(part.slices.size());
  REQUIRE_EQ(static_cast<int>(result.loose.size()), height);
  for (int n = 0; n < height; ++n) {
    CAPTURE(n);
    const auto i = static_cast<std::size_t>(n);
    const Mask solid = part.slices[i] & ~result.loose[i];
    const Mask expected = test::paper_solid<MaskOperations>(part.slices, part.inners, n, t);
    REQUIRE_EQ(solid, expected);
    // As soon as it is settled: at once near the bed, else T layers later, at most at the end.
    REQUIRE_EQ(result.left_at[i], std::min(n < t ? n + 1 : n + t + 1, height));
  }
  REQUIRE_EQ(result.finishes, std::clamp(height - t, 0, t));
}

}  // namespace

TEST_CASE("the fold is the paper's formula, for every T up to 8 and every height up to 40") {
  constexpr unsigned kSeed = 20'000'914;
  CAPTURE(kSeed);
  std::mt19937_64 random(kSeed);
  int layers_with_inside = 0;
  for (int t = 1; t <= 8; ++t) {
    CAPTURE(t);
    for (int height = 0; height <= 40; ++height) {
      CAPTURE(height);
      for (const unsigned rarity : {2u, 5u, 20u, 100u}) {
        CAPTURE(rarity);
        const Part part = random_part(height, rarity, random);
        check_against_paper(part, t);
        for (const Mask loose : run(part, t).loose) layers_with_inside += loose != 0 ? 1 : 0;
      }
    }
  }
  // Not vacuous: there was something loose in a good part of the 26,240 layers.
  CHECK_GT(layers_with_inside, 5'000);
}

TEST_CASE("every column of seven layers or fewer") {
  // Each layer of a column is outside, wall or inside: 3^height columns, 64 to a part.
  for (int height = 1; height <= 7; ++height) {
    int columns = 1;
    for (int n = 0; n < height; ++n) columns *= 3;
    for (int first = 0; first < columns; first += 64) {
      Part part{std::vector<Mask>(static_cast<std::size_t>(height)),
                std::vector<Mask>(static_cast<std::size_t>(height))};
      for (int column = first; column < std::min(first + 64, columns); ++column) {
        int digits = column;
        const Mask bit = Mask{1} << (column - first);
        for (std::size_t n = 0; n < part.slices.size(); ++n, digits /= 3) {
          if (digits % 3 >= 1) part.slices[n] |= bit;
          if (digits % 3 == 2) part.inners[n] |= bit;
        }
      }
      CAPTURE(height);
      CAPTURE(first);
      for (int t = 1; t <= 4; ++t) check_against_paper(part, t);
    }
  }
}

TEST_CASE("the largest T, and a part that is just long enough for it") {
  constexpr int t = core::kWallLayersMax;
  for (const int height : {2 * t, 2 * t + 1, 2 * t + 2}) {
    Part part;
    part.slices.assign(static_cast<std::size_t>(height), ~Mask{0});
    part.inners = part.slices;
    check_against_paper(part, t);
    const Run result = run(part, t);
    const auto inside = std::count(result.loose.begin(), result.loose.end(), ~Mask{0});
    CHECK_EQ(inside, height - 2 * t);
  }
}

TEST_CASE("what is held does not grow with the part") {
  MaskFold fold(5);
  for (int n = 0; n < 100; ++n) (void)fold.push(n, ~Mask{0});
  const std::size_t items = fold.items_held_peak();
  const std::size_t partials = fold.partials_held();
  for (int n = 100; n < 10'000; ++n) (void)fold.push(n, ~Mask{0});
  CHECK_EQ(fold.items_held_peak(), items);
  CHECK_EQ(fold.partials_held(), partials);
  CHECK_EQ(items, 6);
  CHECK_EQ(partials, 10);
}
