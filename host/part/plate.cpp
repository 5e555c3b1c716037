#include "host/part/plate.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "core/limits.h"             // kObjectsMax
#include "host/part/arrangement.h"   // arranged
#include "host/part/merged_rings.h"  // MergedRings
#include "host/part/moved_slice.h"   // moved
#include "host/part/part_file.h"     // open_part
#include "host/part/part_items.h"    // object_name
#include "host/part/plate_parts.h"   // PlatePart, open_parts

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Length;
using core::Result;
using core::Slice;
using core::Status;

class Plate : public LayerSource {
 public:
  Plate(std::vector<PlatePart> parts, core::Settings settings)
      : parts_(std::move(parts)), settings_(std::move(settings)) {}

  [[nodiscard]] bool all_read() const {
    return std::none_of(parts_.begin(), parts_.end(), [](const PlatePart& part) {
      return static_cast<bool>(part.opened.read_rest);
    });
  }

  // Reads each part to its end, and arranges all of them.
  [[nodiscard]] Result<PartSummary> read_rest() {
    for (PlatePart& part : parts_) {
      if (!part.opened.read_rest) continue;
      Result<PartSummary> read = part.opened.read_rest();
      if (!read.ok()) return read;
      part.opened.summary = std::move(read).value();
      part.opened.read_rest = nullptr;
    }
    if (Status placed = place(); !placed.ok()) return placed.error();
    summarise();
    return summary_;
  }

  [[nodiscard]] Result<std::optional<Slice>> next() override {
    std::optional<Slice> merged;
    std::string first;
    MergedRings rings;
    for (PlatePart& part : parts_) {
      if (part.ended) continue;
      Result<std::optional<Slice>> read = part.opened.layers->next();
      if (!read.ok()) return read;
      part.ended = !read.value();
      if (part.ended) continue;
      Slice slice = *std::move(read).value();
      rings.add(slice, room_of(part), part.places);
      slice.defects = moved(slice.defects, part.places.front());
      if (!merged) {
        merged.emplace(std::move(slice));
        first = part.title;
        continue;
      }
      if (slice.bottom != merged->bottom || slice.height != merged->height) {
        return different_layers(part.title, slice, first, *merged);
      }
      merged->defects.add(slice.defects);
    }
    if (merged) rings.put_into(*merged);
    return merged;
  }

  // Whether all of it can be shown, and does so.
  [[nodiscard]] bool can_draw() const {
    return std::all_of(parts_.begin(), parts_.end(),
                       [](const PlatePart& part) { return static_cast<bool>(part.opened.draw); });
  }
  [[nodiscard]] Status draw(const FacetObserver& on_facet) const {
    for (const PlatePart& part : parts_) {
      Status drawn = part.opened.draw([&](const core::Triangle& facet) {
        for (const Shift& shift : part.places) on_facet(shifted(facet, shift));
      });
      if (!drawn.ok()) return drawn;
    }
    return {};
  }

  [[nodiscard]] PartCounters counters() const {
    PartCounters all;
    for (const PlatePart& part : parts_) {
      const PartCounters one = part.opened.counters();
      all.peak_triangles_held += one.peak_triangles_held;
      all.read_cpu_s += one.read_cpu_s;
      all.sort_cpu_s += one.sort_cpu_s;
      all.slice_cpu_s += one.slice_cpu_s;
      all.spilled_bytes += one.spilled_bytes;
    }
    return all;
  }

  // REQUIRES: read_rest() was fine.
  [[nodiscard]] std::vector<PlateObject> objects() const {
    std::vector<PlateObject> objects;
    for (const PlatePart& part : parts_) {
      for (const Shift& shift : part.places) {
        const PartObject& object = summary_.objects[objects.size()];
        objects.push_back({part.path, part.settings, shift, object, part.opened.summary.layers});
        objects.back().object.items = part.items;
      }
    }
    return objects;
  }

  [[nodiscard]] const PartSummary& summary() const { return summary_; }
  // Each once: copies have the same.
  [[nodiscard]] std::vector<std::string> modifiers() const {
    std::vector<std::string> all;
    for (const PlatePart& part : parts_) {
      for (const std::string& one : part.opened.modifiers) {
        std::string text = parts_.size() == 1 ? one : part.title + ": " + one;
        if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(std::move(text));
      }
    }
    return all;
  }
  [[nodiscard]] bool enforced() const {
    return std::any_of(parts_.begin(), parts_.end(),
                       [](const PlatePart& part) { return part.opened.enforced; });
  }

 private:
  // REQUIRES: all have been read.
  [[nodiscard]] Status place() {
    std::vector<Footprint> things;
    for (const PlatePart& part : parts_) {
      const core::Box& box = part.opened.summary.box;
      if (box.empty()) {
        return Error{ErrorCode::kBadPart,
                     part.title +
                         ": its size is known only at its end, so it can't be laid beside others; "
                         "print it alone, or from a file"};
      }
      things.insert(things.end(), part.places.size(),
                    Footprint{Length::from_units(std::int64_t{box.max.x} - box.min.x),
                              Length::from_units(std::int64_t{box.max.y} - box.min.y)});
    }
    const Result<std::vector<core::Point>> corners = arranged(things, settings_);
    if (!corners.ok()) return corners.error();
    std::size_t object = 0;
    for (PlatePart& part : parts_) {
      const PartSummary& summary = part.opened.summary;
      for (Shift& shift : part.places) {
        const core::Point corner = corners.value()[object++];
        shift = {std::int64_t{corner.x} - summary.box.min.x,
                 std::int64_t{corner.y} - summary.box.min.y, 0};
        add_objects(part, shift);
      }
    }
    return {};
  }

  // Whether not too many objects come of it.
  [[nodiscard]] bool items_apart() const {
    std::size_t count = 0;
    for (const PlatePart& part : parts_) {
      count += part.places.size() * std::max<std::size_t>(1, part.opened.summary.objects.size());
    }
    return count <= core::kObjectsMax;
  }

  // The part is one object, or its items are.
  void add_objects(const PlatePart& part, const Shift& shift) {
    const PartSummary& summary = part.opened.summary;
    std::vector<PartObject> objects = summary.objects;
    if (objects.empty() || !items_apart())
      objects = {{"", summary.box, summary.height, part.name, {}}};
    for (PartObject& object : objects) {
      object.name = object_name(object.title, summary_.objects.size() + 1);
      object.box = shifted(object.box, shift);
      summary_.objects.push_back(std::move(object));
    }
  }

  // The box of an object before it is moved, and less than half the gap between objects around it.
  [[nodiscard]] core::Box room_of(const PlatePart& part) const {
    const auto around = static_cast<std::int32_t>(object_gap(settings_).units() / 3);
    core::Box room = part.opened.summary.box;
    room.min = {room.min.x - around, room.min.y - around};
    room.max = {room.max.x + around, room.max.y + around};
    return room;
  }

  void summarise() {
    const PartSummary& first = parts_.front().opened.summary;
    summary_.format = parts_.size() == 1 ? first.format : fmt::format("{} files", parts_.size());
    summary_.nothing_hangs = true;
    summary_.lowest_layer = first.lowest_layer;
    summary_.highest_layer = first.highest_layer;
    for (const PlatePart& part : parts_) {
      const PartSummary& one = part.opened.summary;
      const auto copies = static_cast<std::int64_t>(part.places.size());
      summary_.facets += one.facets * copies;
      summary_.degenerate += one.degenerate * copies;
      summary_.height = std::max(summary_.height, one.height);
      summary_.layers = std::max(summary_.layers, one.layers);
      summary_.lowest_layer = std::min(summary_.lowest_layer, one.lowest_layer);
      summary_.highest_layer = std::max(summary_.highest_layer, one.highest_layer);
      summary_.nothing_hangs = summary_.nothing_hangs && one.nothing_hangs;
      for (const std::string& warning : one.warnings) {
        std::vector<std::string>& all = summary_.warnings;
        if (std::find(all.begin(), all.end(), warning) == all.end()) all.push_back(warning);
      }
    }
    for (const PartObject& object : summary_.objects) summary_.box.add(object.box);
  }

  [[nodiscard]] static Error different_layers(const std::string& title, const Slice& slice,
                                              const std::string& first, const Slice& of_first) {
    return {ErrorCode::kBadPart,
            fmt::format("{}, layer {}: it lies from {:g} to {:g} mm, that of {} from {:g} to {:g} "
                        "mm; parts with different layers can't be printed together: print "
                        "one after the other",
                        title, slice.index + 1, slice.bottom.mm(), slice.top().mm(), first,
                        of_first.bottom.mm(), of_first.top().mm())};
  }

  std::vector<PlatePart> parts_;
  core::Settings settings_;
  PartSummary summary_;
};

OpenedPart part_of(std::unique_ptr<Plate> plate) {
  OpenedPart part;
  Plate* source = plate.get();
  part.enforced = plate->enforced();
  part.modifiers = plate->modifiers();
  part.counters = [source] { return source->counters(); };
  if (plate->can_draw()) {
    part.draw = [source](const FacetObserver& on_facet) { return source->draw(on_facet); };
  }
  part.layers = std::move(plate);
  return part;
}

}  // namespace

bool is_plate(const std::vector<std::string>& paths, const core::Settings& settings) {
  return paths.size() > 1 || settings.copies > 1 || pieces_of(settings).size() > 1;
}

Result<OpenedPart> open_plate(const std::vector<std::string>& paths, const core::Settings& settings,
                              const OpenOptions& options) {
  Result<std::vector<PlatePart>> parts = open_parts(paths, settings, options);
  if (!parts.ok()) return parts.error();
  auto plate = std::make_unique<Plate>(std::move(parts).value(), settings);
  Plate* source = plate.get();
  OpenedPart part = part_of(std::move(plate));
  if (!source->all_read()) {
    part.read_rest = [source] { return source->read_rest(); };
    return part;
  }
  Result<PartSummary> summary = source->read_rest();
  if (!summary.ok()) return summary.error();
  part.summary = std::move(summary).value();
  return part;
}

Result<PlateSurvey> survey_plate(const std::vector<std::string>& paths,
                                 const core::Settings& settings, const OpenOptions& options) {
  Result<std::vector<PlatePart>> parts = open_parts(paths, settings, options);
  if (!parts.ok()) return parts.error();
  OpenOptions each = options;
  each.stream_pipes = false;
  each.on_facet = {};
  parts = with_items_apart(std::move(parts).value(), settings, each);
  if (!parts.ok()) return parts.error();
  Plate plate(std::move(parts).value(), settings);
  Result<PartSummary> summary = plate.read_rest();
  if (!summary.ok()) return summary.error();
  return PlateSurvey{std::move(summary).value(), plate.objects()};
}

Result<OpenedPart> open_object(const PlateObject& object, const OpenOptions& options) {
  OpenOptions alone = options;
  alone.stream_pipes = false;
  alone.on_facet = {};
  alone.items = object.object.items;
  Result<OpenedPart> opened = read_whole(open_part(object.path, object.settings, alone));
  if (!opened.ok()) return opened;
  PartSummary summary = opened.value().summary;
  summary.box = object.object.box;
  summary.objects.clear();
  std::vector<PlatePart> parts;
  parts.push_back({object.path,
                   part_title_of(object.path),
                   object.settings,
                   std::move(opened).value(),
                   {object.shift}});
  OpenedPart part = part_of(std::make_unique<Plate>(std::move(parts), object.settings));
  part.summary = std::move(summary);
  return part;
}

}  // namespace host
