// Supports of a part of which only some layers are known, against the fold over the whole part and
// against cells, where everything can be counted.
#include "core/supports/support_lookahead.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "tests/support/cell_stacks.h"
#include "tests/support/layer_stacks.h"
#include "tests/support/region_checks.h"
#include "tests/support/region_text.h"

using namespace core;
using test::Cells;

namespace {

struct Found {
  std::vector<SupportLayer> layers;
  std::vector<SupportLookahead::Cut> cuts;
  std::size_t most_held = 0;
};

Found found_ahead(const std::vector<Region>& slices, const Settings& settings) {
  SupportLookahead lookahead(settings);
  Found found;
  const auto take = [&] {
    while (auto layer = lookahead.next()) {
      CHECK_EQ(layer->index, static_cast<LayerIndex>(found.layers.size()));
      found.layers.push_back(*layer);
    }
    if (auto cut = lookahead.take_cut()) found.cuts.push_back(*cut);
    found.most_held = std::max(found.most_held, lookahead.held());
  };
  SharedRegion last;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    if (!last || !(*last == slices[i])) last = std::make_shared<const Region>(slices[i]);
    const Length height = settings.layer_height;
    const auto index = static_cast<LayerIndex>(i);
    lookahead.push({index, height * static_cast<std::int64_t>(i), height, last});
    take();
  }
  lookahead.end();
  take();
  CHECK_EQ(found.layers.size(), slices.size());
  return found;
}

std::vector<SupportLayer> found_whole(const std::vector<Region>& slices, const Settings& settings) {
  SupportFold fold(settings);
  std::vector<SupportLayer> found(slices.size());
  const auto take = [&] {
    while (auto layer = fold.next()) found[static_cast<std::size_t>(layer->index)] = *layer;
  };
  for (std::size_t i = slices.size(); i-- > 0;) {
    const Length height = settings.layer_height;
    fold.push({static_cast<LayerIndex>(i), height * static_cast<std::int64_t>(i), height,
               std::make_shared<const Region>(slices[i])});
    take();
  }
  fold.end();
  take();
  return found;
}

bool same(const std::vector<SupportLayer>& a, const std::vector<SupportLayer>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.index == other.index && *one.region == *other.region &&
           *one.interface == *other.interface;
  });
}

// The method of the header on cells, with all layers at hand.
struct CellsFound {
  std::vector<Cells> laid;
  std::vector<LayerIndex> cuts;
};

CellsFound cells_found(const std::vector<Cells>& stack, std::size_t lookahead) {
  CellsFound found;
  const auto wanted = [&](std::size_t n, std::size_t known, std::size_t cell) {
    if (stack[n][cell]) return false;
    for (std::size_t m = n + 1; m <= std::min(known, stack.size() - 1); ++m) {
      if (stack[m][cell]) return true;
    }
    return false;
  };
  std::size_t known = 0;
  for (std::size_t block = 0; block < stack.size();) {
    const std::size_t known_before = known;
    known = std::min(block + 2 * lookahead, stack.size()) - 1;
    const bool last = known + 1 == stack.size();
    const std::size_t end =
        last && known + 1 < block + 2 * lookahead ? stack.size() : block + lookahead;
    bool cut = false, told = false;
    for (std::size_t i = 0; block > 0 && i < stack[0].size(); ++i) {
      const bool now = wanted(block - 1, known, i);
      cut |= now && !found.laid[block - 1][i];
      told |= now && !wanted(block - 1, known_before, i);
    }
    if (told) found.cuts.push_back(static_cast<LayerIndex>(block));
    for (std::size_t n = block; n < end; ++n) {
      Cells laid(stack[n].size());
      for (std::size_t i = 0; i < laid.size(); ++i) {
        laid[i] = wanted(n, known, i) && (!cut || found.laid[n - 1][i] || stack[n - 1][i]);
      }
      found.laid.push_back(std::move(laid));
    }
    block = end;
  }
  return found;
}

}  // namespace

TEST_CASE("what is known so many layers up is held as the literal formula says, cell by cell") {
  int cuts = 0;
  for (std::uint64_t seed = 40; seed < 60; ++seed) {
    CAPTURE(seed);
    const int layers = 5 + static_cast<int>(seed % 7);
    const std::vector<Cells> stack = test::random_cells(seed, layers, 0.2);
    Settings settings = test::settings_of_cells();
    settings.support_lookahead = 1 + static_cast<int>(seed % 3);
    const Found found = found_ahead(test::regions_of(stack), settings);
    const CellsFound literal =
        cells_found(stack, static_cast<std::size_t>(settings.support_lookahead));
    for (std::size_t n = 0; n < stack.size(); ++n) {
      CAPTURE(n);
      CHECK_LT(
          test::widest_difference(*found.layers[n].region, test::region_of_cells(literal.laid[n])),
          test::kCellCornerUnits);
    }
    REQUIRE_EQ(found.cuts.size(), literal.cuts.size());
    for (std::size_t i = 0; i < literal.cuts.size(); ++i) {
      CHECK_EQ(found.cuts[i].index, literal.cuts[i]);
    }
    cuts += static_cast<int>(found.cuts.size());
  }
  CHECK_GT(cuts, 10);
}

TEST_CASE("where nothing has to begin further down, it is what a fold over the whole part finds") {
  Settings settings;
  settings.supports = SupportPlace::kEverywhere;
  for (const std::uint64_t seed : {3u, 4u}) {
    CAPTURE(seed);
    const std::vector<Region> slices = test::wandering_stack(24, seed).slices;
    const std::vector<SupportLayer> whole = found_whole(slices, settings);
    for (const int lookahead : {24, 13, 40}) {
      CAPTURE(lookahead);
      settings.support_lookahead = lookahead;
      const Found found = found_ahead(slices, settings);
      if (lookahead >= 24) CHECK(found.cuts.empty());
      if (found.cuts.empty()) CHECK(same(found.layers, whole));
    }
  }
  // Shelves of which each begins at most eight layers over what holds it.
  Settings bare = test::settings_of_cells();
  std::vector<Region> slices;
  for (int shelf = 0; shelf < 5; ++shelf) {
    slices.insert(slices.end(), 8, test::rectangle_region(0, 0, 4, 4));
    slices.insert(slices.end(), 2, test::rectangle_region(0, 0, 12, 4));
  }
  bare.support_lookahead = 8;
  const Found found = found_ahead(slices, bare);
  CHECK(found.cuts.empty());
  CHECK(same(found.layers, found_whole(slices, bare)));
  CHECK_FALSE(found.layers[44].empty());
}

TEST_CASE("from the bed, only what stands on the bed is laid") {
  Settings settings = test::settings_of_cells();
  settings.supports = SupportPlace::kBed;
  settings.support_lookahead = 5;
  std::vector<Region> slices(20, test::rectangle_region(0, 0, 4, 4));
  slices.push_back(test::rectangle_region(0, 0, 12, 4));
  const Found late = found_ahead(slices, settings);
  for (const SupportLayer& layer : late.layers) CHECK(layer.empty());
  REQUIRE_EQ(late.cuts.size(), 1);
  CHECK_EQ(late.cuts.front().index, 15);
  CHECK_EQ(late.cuts.front().known, 20);
  settings.support_lookahead = 20;
  const Found early = found_ahead(slices, settings);
  CHECK(early.cuts.empty());
  for (std::size_t n = 0; n < 20; ++n) CHECK_FALSE(early.layers[n].empty());
}

TEST_CASE("so many slices are held, however high the part is") {
  Settings settings = test::settings_of_cells();
  settings.support_lookahead = 10;
  settings.support_bottom_gap_layers = 2;
  settings.support_bottom_interface_layers = 1;
  std::vector<Region> slices;
  for (int n = 0; n < 2'000; ++n) {
    slices.push_back(test::rectangle_region(0, 0, n % 7 == 6 ? 12 : 4, 4));
  }
  const Found found = found_ahead(slices, settings);
  CHECK_LE(found.most_held, 2 * 10 + 3 + 1);
  CHECK(found.cuts.empty());
}
