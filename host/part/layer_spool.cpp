#include "host/part/layer_spool.h"

#include <bit>
#include <utility>
#include <vector>

#include "core/check.h"     // RIND_CHECK
#include "core/geometry.h"  // Point, Ring

namespace host {
namespace {

using core::Region;
using core::Ring;

enum class RegionForm : std::uint8_t { kEmpty, kHere, kElsewhere };

// Whole numbers in groups of 7 bits, the lowest first; signed ones with their sign in bit 0.
void put(std::uint64_t value, std::string& into) {
  while (value >= 0x80) {
    into.push_back(static_cast<char>((value & 0x7f) | 0x80));
    value >>= 7;
  }
  into.push_back(static_cast<char>(value));
}

void put_signed(std::int64_t value, std::string& into) {
  const auto bits = static_cast<std::uint64_t>(value);
  put((bits << 1) ^ (value < 0 ? ~std::uint64_t{0} : 0), into);
}

class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      RIND_CHECK(at_ < bytes_.size() && shift < 64);
      const auto byte = static_cast<std::uint8_t>(bytes_[at_++]);
      value |= std::uint64_t{byte & 0x7fU} << shift;
      if (byte < 0x80) return value;
    }
  }

  std::int64_t signed_number() {
    const std::uint64_t value = number();
    return static_cast<std::int64_t>((value >> 1) ^ (value % 2 != 0 ? ~std::uint64_t{0} : 0));
  }

  std::string text(std::size_t size) {
    RIND_CHECK(size <= bytes_.size() - at_);
    at_ += size;
    return std::string(bytes_.substr(at_ - size, size));
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

void put_region(const Region& region, std::string& into) {
  put(region.rings().size(), into);
  core::Point last;
  for (const Ring& ring : region.rings()) {
    put(ring.size(), into);
    for (const core::Point point : ring) {
      put_signed(std::int64_t{point.x} - last.x, into);
      put_signed(std::int64_t{point.y} - last.y, into);
      last = point;
    }
  }
}

Region region_in(Bytes& bytes) {
  std::vector<Ring> rings(bytes.number());
  core::Point last;
  for (Ring& ring : rings) {
    ring.resize(bytes.number());
    for (core::Point& point : ring) {
      last.x = static_cast<std::int32_t>(last.x + bytes.signed_number());
      last.y = static_cast<std::int32_t>(last.y + bytes.signed_number());
      point = last;
    }
  }
  return Region::from_clean_rings(std::move(rings));
}

void put_defects(const core::SliceDefects& defects, std::string& into) {
  put(defects.any() ? 1 : 0, into);
  if (!defects.any()) return;
  for (const std::int64_t count :
       {defects.closed_chains, defects.dropped_chains, defects.wide_chains,
        defects.widest_gap.units(), defects.flipped_facets, defects.doubled_facets,
        defects.turned_contours}) {
    put_signed(count, into);
  }
  put(defects.turned_at ? 1 : 0, into);
  if (!defects.turned_at) return;
  put_signed(defects.turned_at->x, into);
  put_signed(defects.turned_at->y, into);
}

core::SliceDefects defects_in(Bytes& bytes) {
  core::SliceDefects defects;
  if (bytes.number() == 0) return defects;
  std::int64_t gap = 0;
  for (std::int64_t* count :
       {&defects.closed_chains, &defects.dropped_chains, &defects.wide_chains, &gap,
        &defects.flipped_facets, &defects.doubled_facets, &defects.turned_contours}) {
    *count = bytes.signed_number();
  }
  defects.widest_gap = core::Length::from_units(gap);
  if (bytes.number() == 0) return defects;
  const auto x = static_cast<std::int32_t>(bytes.signed_number());
  const auto y = static_cast<std::int32_t>(bytes.signed_number());
  defects.turned_at = core::Point{x, y};
  return defects;
}

void put_note(const std::optional<std::string>& note, std::string& into) {
  put(note ? note->size() + 1 : 0, into);
  if (note) into += *note;
}

void put_value(const std::optional<double>& value, std::string& into) {
  put(value ? 1 : 0, into);
  if (value) put(std::bit_cast<std::uint64_t>(*value), into);
}

std::optional<double> value_in(Bytes& bytes) {
  if (bytes.number() == 0) return std::nullopt;
  return std::bit_cast<double>(bytes.number());
}

void put_areas(const std::shared_ptr<const core::ChangedAreas>& areas, std::string& into) {
  put(areas ? areas->size() : 0, into);
  if (!areas) return;
  for (const core::ChangedArea& area : *areas) {
    put_value(area.change.density, into);
    const std::optional<core::LoosePattern> pattern = area.change.pattern;
    put(pattern ? static_cast<std::uint64_t>(*pattern) + 1 : 0, into);
    put(static_cast<std::uint64_t>(area.change.perimeters.value_or(0)), into);
    for (const std::optional<double>& value : area.change.laid) put_value(value, into);
    put_region(area.region, into);
  }
}

std::shared_ptr<const core::ChangedAreas> areas_in(Bytes& bytes) {
  const std::uint64_t count = bytes.number();
  if (count == 0) return nullptr;
  core::ChangedAreas areas(count);
  for (core::ChangedArea& area : areas) {
    area.change.density = value_in(bytes);
    const std::uint64_t pattern = bytes.number();
    if (pattern > 0) area.change.pattern = static_cast<core::LoosePattern>(pattern - 1);
    const std::uint64_t perimeters = bytes.number();
    if (perimeters > 0) area.change.perimeters = static_cast<int>(perimeters);
    for (std::optional<double>& value : area.change.laid) value = value_in(bytes);
    area.region = region_in(bytes);
  }
  return std::make_shared<const core::ChangedAreas>(std::move(areas));
}

SpooledLayer head_in(Bytes& bytes) {
  SpooledLayer layer;
  layer.index = bytes.signed_number();
  layer.bottom = core::Length::from_units(bytes.signed_number());
  layer.height = core::Length::from_units(bytes.signed_number());
  layer.defects = defects_in(bytes);
  if (const std::uint64_t size = bytes.number(); size > 0) layer.note = bytes.text(size - 1);
  return layer;
}

}  // namespace

core::Result<LayerSpool> LayerSpool::create(const std::string& folder, SpillUse use) {
  core::Result<RecordSpool> spool = RecordSpool::create(folder, use);
  if (!spool.ok()) return spool.error();
  return LayerSpool(std::move(spool).value());
}

core::Status LayerSpool::append(const SpooledLayer& layer) {
  std::string record;
  put_signed(layer.index, record);
  put_signed(layer.bottom.units(), record);
  put_signed(layer.height.units(), record);
  put_defects(layer.defects, record);
  put_note(layer.note, record);
  for (std::size_t i = 0; i < layer.regions.size(); ++i) {
    const SharedRegion& region = layer.regions[i];
    Known& known = written_[i];
    if (!region || region->empty()) {
      put(static_cast<std::uint64_t>(RegionForm::kEmpty), record);
    } else if (known.region && (known.region == region || *known.region == *region)) {
      put(static_cast<std::uint64_t>(RegionForm::kElsewhere), record);
      put(static_cast<std::uint64_t>(known.at), record);
    } else {
      put(static_cast<std::uint64_t>(RegionForm::kHere), record);
      put_region(*region, record);
      known = {spool_.next_place(), region};
    }
  }
  put_areas(layer.areas, record);
  return spool_.append(record);
}

core::Result<std::optional<SpooledLayer>> LayerSpool::next() {
  core::Result<std::optional<RecordSpool::Record>> record = spool_.next();
  if (!record.ok()) return record.error();
  if (!record.value()) return std::optional<SpooledLayer>();
  core::Result<SpooledLayer> layer = layer_of(*record.value());
  if (!layer.ok()) return layer.error();
  return std::optional<SpooledLayer>(std::move(layer).value());
}

core::Result<std::optional<SpooledLayer>> LayerSpool::previous() {
  core::Result<std::optional<RecordSpool::Record>> record = spool_.previous();
  if (!record.ok()) return record.error();
  if (!record.value()) return std::optional<SpooledLayer>();
  core::Result<SpooledLayer> layer = layer_of(*record.value());
  if (!layer.ok()) return layer.error();
  return std::optional<SpooledLayer>(std::move(layer).value());
}

core::Result<SpooledLayer> LayerSpool::layer_of(const RecordSpool::Record& record) {
  static const SharedRegion kNone = std::make_shared<const Region>();
  Bytes bytes(record.bytes);
  SpooledLayer layer = head_in(bytes);
  std::array<std::int64_t, SpooledLayer::kRegions> elsewhere{};
  for (std::size_t i = 0; i < layer.regions.size(); ++i) {
    elsewhere[i] = -1;
    const auto form = static_cast<RegionForm>(bytes.number());
    if (form == RegionForm::kEmpty) {
      layer.regions[i] = kNone;
    } else if (form == RegionForm::kElsewhere) {
      elsewhere[i] = static_cast<std::int64_t>(bytes.number());
    } else {
      // Of a record that is read once more, the known object stays.
      Region region = region_in(bytes);
      if (read_[i].at != record.at) {
        read_[i] = {record.at, std::make_shared<const Region>(std::move(region))};
      }
      layer.regions[i] = read_[i].region;
    }
  }
  layer.areas = areas_in(bytes);
  // These may read other records, into the same buffer.
  for (std::size_t i = 0; i < layer.regions.size(); ++i) {
    if (elsewhere[i] < 0) continue;
    core::Result<SharedRegion> region = region_at(elsewhere[i], i);
    if (!region.ok()) return region.error();
    layer.regions[i] = std::move(region).value();
  }
  return layer;
}

core::Result<LayerSpool::SharedRegion> LayerSpool::region_at(std::int64_t place,
                                                             std::size_t number) {
  if (read_[number].at == place) return read_[number].region;
  core::Result<RecordSpool::Record> record = spool_.read_at(place);
  if (!record.ok()) return record.error();
  Bytes bytes(record.value().bytes);
  static_cast<void>(head_in(bytes));
  for (std::size_t i = 0; i <= number; ++i) {
    const auto form = static_cast<RegionForm>(bytes.number());
    if (form == RegionForm::kElsewhere) static_cast<void>(bytes.number());
    if (form != RegionForm::kHere) continue;
    Region region = region_in(bytes);
    if (i < number) continue;
    read_[number] = {place, std::make_shared<const Region>(std::move(region))};
  }
  RIND_CHECK(read_[number].at == place);
  return read_[number].region;
}

}  // namespace host
