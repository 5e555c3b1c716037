// Layers in a temporary file (record_spool.h): each with some regions, written in one order and
// read in either. A region that equals the one before in its place takes a few bytes, and is read
// as the same object.
//
//     record:  index, bottom, height · defects · note · regions
//     region:  empty | rings, as differences of coordinates | place of the record that has it
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/regions/region.h"      // Region
#include "core/result.h"              // Result, Status
#include "core/slices/slice.h"        // SliceDefects
#include "core/units.h"               // LayerIndex, Length
#include "host/files/record_spool.h"  // RecordSpool

namespace host {

struct SpooledLayer {
  static constexpr std::size_t kRegions = 4;

  core::LayerIndex index = 0;
  core::Length bottom;
  core::Length height;
  core::SliceDefects defects;
  std::optional<std::string> note;
  std::array<std::shared_ptr<const core::Region>, kRegions> regions;  // null is empty, too
  std::shared_ptr<const core::ChangedAreas> areas;  // written whole with each layer
};

class LayerSpool {
 public:
  // Errors: as SpillFile.
  static core::Result<LayerSpool> create(const std::string& folder, SpillUse use);

  [[nodiscard]] core::Status append(const SpooledLayer& layer);

  // From the first record on; or from the last one back. After one of them, the other starts anew.
  void read_forwards() { spool_.go_to_start(); }
  void read_backwards() { spool_.go_to_end(); }
  // nullopt at the end. Errors: of the disk.
  [[nodiscard]] core::Result<std::optional<SpooledLayer>> next();
  [[nodiscard]] core::Result<std::optional<SpooledLayer>> previous();

  [[nodiscard]] std::int64_t bytes() const { return spool_.size(); }
  [[nodiscard]] const SpillFile& file() const { return spool_.file(); }

 private:
  using SharedRegion = std::shared_ptr<const core::Region>;
  // The latest region of a place, and the record that has it.
  struct Known {
    std::int64_t at = -1;
    SharedRegion region;
  };

  explicit LayerSpool(RecordSpool spool) : spool_(std::move(spool)) {}

  [[nodiscard]] core::Result<SpooledLayer> layer_of(const RecordSpool::Record& record);
  [[nodiscard]] core::Result<SharedRegion> region_at(std::int64_t place, std::size_t number);

  RecordSpool spool_;
  std::array<Known, SpooledLayer::kRegions> written_, read_;
};

}  // namespace host
