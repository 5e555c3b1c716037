#include "tools/oracles/clipper2_calls.h"

#ifdef RIND_CLIPPER2
#include <clipper2/clipper.h>
#endif

namespace clipper2 {

#ifdef RIND_CLIPPER2

namespace {

using Clipper2Lib::ClipType;
using Clipper2Lib::Paths64;

Paths64 paths_of(const core::Region& region) {
  Paths64 paths;
  for (const core::Ring& ring : region.rings()) {
    paths.emplace_back();
    for (const core::Point p : ring) paths.back().emplace_back(p.x, p.y);
  }
  return paths;
}

Call booleans(const RegionPairs& pairs, ClipType type) {
  std::vector<std::pair<Paths64, Paths64>> all;
  for (const auto& [a, b] : pairs) all.emplace_back(paths_of(a), paths_of(b));
  return [all = std::move(all), type] {
    std::size_t rings = 0;
    for (const auto& [a, b] : all) {
      Clipper2Lib::Clipper64 sheet;
      sheet.AddSubject(a);
      sheet.AddClip(b);
      Paths64 out;
      sheet.Execute(type, Clipper2Lib::FillRule::NonZero, out);
      rings += out.size();
    }
    return rings;
  };
}

}  // namespace

bool found() { return true; }

Call offsets(const std::vector<core::Region>& regions, core::Length depth, core::Length tolerance) {
  std::vector<Paths64> all;
  for (const core::Region& region : regions) all.push_back(paths_of(region));
  return [all = std::move(all), depth, tolerance] {
    std::size_t rings = 0;
    for (const Paths64& paths : all) {
      Clipper2Lib::ClipperOffset offset(2, static_cast<double>(tolerance.units()));
      offset.AddPaths(paths, Clipper2Lib::JoinType::Round, Clipper2Lib::EndType::Polygon);
      Paths64 out;
      offset.Execute(-static_cast<double>(depth.units()), out);
      rings += out.size();
    }
    return rings;
  };
}

Call intersections(const RegionPairs& pairs) { return booleans(pairs, ClipType::Intersection); }
Call differences(const RegionPairs& pairs) { return booleans(pairs, ClipType::Difference); }

#else

bool found() { return false; }
Call offsets(const std::vector<core::Region>&, core::Length, core::Length) { return {}; }
Call intersections(const RegionPairs&) { return {}; }
Call differences(const RegionPairs&) { return {}; }

#endif

}  // namespace clipper2
