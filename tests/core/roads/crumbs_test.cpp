#include "core/roads/crumbs.h"

#include <doctest/doctest.h>

#include <memory>
#include <vector>

#include "tests/support/region_text.h"

using namespace core;

namespace {

Road gap(std::vector<Point> points, double width_mm = 0.4) {
  return {RoadKind::kGapFill, Length::from_mm(width_mm), false, std::move(points)};
}

SplitLayer layer(const Region& slice, const Region& below, const Region& above) {
  SplitLayer split;
  split.slice.region = slice;
  split.below = std::make_shared<const Region>(below);
  split.above = std::make_shared<const Region>(above);
  return split;
}

const Region kSquare = test::region_from_text("0:0 20:0 20:20 0:20");
const Road kRow{
    RoadKind::kSolid, Length::from_mm(0.45), false, {{50'000, 50'000}, {90'000, 50'000}}};
const Road kCrumb = gap({{100'000, 100'000}, {106'000, 100'000}, {109'000, 102'000}});

std::size_t left(const SplitLayer& split, std::vector<Road> roads) {
  drop_crumbs(split, Settings(), roads);
  return roads.size();
}

}  // namespace

TEST_CASE("a crumb goes, what is larger, of another kind or beside another road stays") {
  const SplitLayer split = layer(kSquare, kSquare, kSquare);
  CHECK_EQ(left(split, {kRow, kCrumb, kRow}), 2);
  CHECK_EQ(left(split, {kCrumb, kCrumb}), 0);
  // Two squares of a road are 0.405 mm².
  CHECK_EQ(left(split, {gap({{100'000, 100'000}, {110'000, 100'000}}, 0.41)}), 1);
  CHECK_EQ(left(split, {gap({{100'000, 100'000}, {110'000, 100'000}}, 0.40)}), 0);
  Road solid = kCrumb;
  solid.kind = RoadKind::kSolid;
  CHECK_EQ(left(split, {solid}), 1);
  Road row = kRow;
  row.points.back() = kCrumb.points.front();
  CHECK_EQ(left(split, {row, kCrumb}), 2);
  // Two that touch are one run: too large together.
  const Road on = gap({kCrumb.points.back(), {109'000, 108'000}});
  CHECK_EQ(left(split, {kCrumb, on}), 2);
}

TEST_CASE("a crumb stays where it is seen") {
  CHECK_EQ(left(layer(kSquare, kSquare, kSquare), {kCrumb}), 0);
  const Region aside = test::region_from_text("0:0 10.5:0 10.5:20 0:20");
  CHECK_EQ(left(layer(kSquare, kSquare, aside), {kCrumb}), 1);
  CHECK_EQ(left(layer(kSquare, aside, kSquare), {kCrumb}), 1);
  const Region narrow = test::region_from_text("0:0 20:0 20:10.4 0:10.4");
  CHECK_EQ(left(layer(narrow, kSquare, kSquare), {kCrumb}), 1);
  SplitLayer lowest = layer(kSquare, kSquare, kSquare);
  lowest.below = nullptr;
  CHECK_EQ(left(lowest, {kCrumb}), 1);
  SplitLayer highest = layer(kSquare, kSquare, kSquare);
  highest.above = nullptr;
  CHECK_EQ(left(highest, {kCrumb}), 1);
}
