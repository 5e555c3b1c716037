// Evaluates the sets of a layer of an L-SIF file to a region (lsif_reader.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>

#include "core/geometry.h"                  // Point
#include "core/regions/region.h"            // Region
#include "core/result.h"                    // Result, Status
#include "host/formats/contour_gatherer.h"  // ContourGatherer
#include "host/formats/sif_scanner.h"       // SifScanner

namespace host {

class LsifSets {
 public:
  // REQUIRES: `scanner` outlives this.
  explicit LsifSets(SifScanner& scanner) : scanner_(scanner) {}

  void set_unit(double mm) { unit_mm_ = mm; }
  void start_layer();
  // Reads one form of a layer to its end. REQUIRES: its keyword has been read.
  [[nodiscard]] core::Status take_form(const std::string& keyword);
  // The union of all sets of the layer.
  [[nodiscard]] core::Result<core::Region> finish_layer();

  [[nodiscard]] std::int64_t skipped_forms() const { return skipped_forms_; }
  [[nodiscard]] const std::string& first_skipped() const { return first_skipped_; }

 private:
  [[nodiscard]] static bool is_set(const std::string& keyword);
  [[nodiscard]] core::Status vertex();
  [[nodiscard]] core::Status contour(Turn turn, ContourGatherer& into);
  [[nodiscard]] core::Status nested(int depth, ContourGatherer& into);
  [[nodiscard]] core::Result<core::Region> set(const std::string& keyword, int depth);
  [[nodiscard]] core::Result<core::Region> boolean(const std::string& keyword, int depth);
  [[nodiscard]] core::Status skip(const std::string& keyword);
  // Counts a point of the layer; an error if there are too many.
  [[nodiscard]] core::Status count_point();

  SifScanner& scanner_;
  double unit_mm_ = 1;
  std::unordered_map<std::int64_t, core::Point> vertices_;
  ContourGatherer sets_;  // the layer's regions so far
  std::size_t points_ = 0;
  std::int64_t skipped_forms_ = 0;
  std::string first_skipped_;
};

}  // namespace host
