#include "host/part/part_file.h"

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/limits.h"                   // kObjectsMax
#include "core/raft_heights.h"             // raft_lift, settings_above_raft
#include "host/files/input_file.h"         // InputFile
#include "host/formats/formats.h"          // kind_of
#include "host/formats/sif_reader.h"       // read_sif
#include "host/formats/triangle_source.h"  // TriangleSource
#include "host/gcode/gcode_kind.h"
#include "host/part/boolean_layers.h"   // open_booleans
#include "host/part/cut_plane.h"        // is_cut
#include "host/part/layer_file.h"       // open_layer_file
#include "host/part/marked_layers.h"    // with_marks
#include "host/part/mesh_layers.h"      // open_mesh
#include "host/part/modified_layers.h"  // with_modifiers
#include "host/part/part_items.h"       // PartItems, watched
#include "host/part/part_transform.h"   // transform

namespace host {
namespace {

using core::Result;

// A function that opens the same file again as the same kind; empty if it can be read only once.
template <typename Reader>
std::function<Result<Reader>()> opener(const InputFile& file, const std::string& path,
                                       FileKind kind, Result<Reader> (*open)(FileKind, InputFile)) {
  if (!file.rereadable()) return {};
  return [path, kind, open]() -> Result<Reader> {
    Result<InputFile> reopened = InputFile::open(path);
    if (!reopened.ok()) return reopened.error();
    return open(kind, std::move(reopened).value());
  };
}

// What shows the facets of an opened mesh once more, from another reading.
std::function<core::Status(const FacetObserver&)> drawing(
    const TriangleOpener& again, const std::function<PartPlacing()>& placing) {
  if (!again) return {};
  return [again, placing](const FacetObserver& on_facet) -> core::Status {
    const Result<std::unique_ptr<TriangleSource>> opened = again();
    if (!opened.ok()) return opened.error();
    const Shift shift = placing().shift;
    while (true) {
      const Result<std::optional<core::Triangle>> next = opened.value()->next();
      if (!next.ok()) return next.error();
      if (!next.value()) return {};
      on_facet(shifted(*next.value(), shift));
    }
  };
}

Result<OpenedPart> open_drawable(MeshInput mesh, const core::Settings& settings,
                                 const OpenOptions& options) {
  const TriangleOpener again = is_cut(settings) ? TriangleOpener() : mesh.again;
  Result<OpenedPart> part = open_mesh(std::move(mesh), settings, options);
  if (part.ok()) part.value().draw = drawing(again, part.value().placing);
  return part;
}

// The part, with its items as objects once it was read.
OpenedPart with_items(OpenedPart part, std::shared_ptr<const PartItems> items,
                      const std::string& name) {
  const auto tell = [items = std::move(items), placing = part.placing, name](PartSummary& summary) {
    // Of what is sliced as it arrives, the end is not known.
    if (summary.layers > 0) summary.objects = items->objects(placing().shift, name);
  };
  if (!part.read_rest) {
    tell(part.summary);
    return part;
  }
  part.read_rest = [tell, read = std::move(part.read_rest)]() -> Result<PartSummary> {
    Result<PartSummary> summary = read();
    if (summary.ok()) tell(summary.value());
    return summary;
  };
  return part;
}

Result<OpenedPart> open_transformed(MeshInput mesh, const core::Settings& settings,
                                    const OpenOptions& options) {
  if (core::Status done = transform(mesh.triangles, mesh.again, settings, mesh.name); !done.ok()) {
    return done.error();
  }
  const std::vector<std::string> names = mesh.triangles->items();
  const bool several = names.size() > 1 && names.size() <= std::size_t{core::kObjectsMax};
  // Pieces of a part are objects themselves.
  if (!several || !options.items.empty() || is_cut(settings)) {
    return open_drawable(std::move(mesh), settings, options);
  }
  const auto items = std::make_shared<PartItems>(names);
  const std::string name = mesh.name;
  mesh.triangles = watched(std::move(mesh.triangles), items);
  if (mesh.again) {
    mesh.again = [open = std::move(mesh.again),
                  items]() -> Result<std::unique_ptr<TriangleSource>> {
      Result<std::unique_ptr<TriangleSource>> opened = open();
      if (!opened.ok()) return opened;
      return watched(std::move(opened).value(), items);
    };
  }
  Result<OpenedPart> part = open_drawable(std::move(mesh), settings, options);
  if (!part.ok()) return part;
  part.value().items = names.size();
  return with_items(std::move(part).value(), items, name);
}

// Of the file's items, those that are asked for; also where it is opened again.
core::Status keep_asked(MeshInput& mesh, const OpenOptions& options) {
  if (options.items.empty()) return {};
  if (core::Status kept = mesh.triangles->keep_items(options.items); !kept.ok()) return kept;
  if (!mesh.again) return {};
  mesh.again = [open = std::move(mesh.again),
                items = options.items]() -> Result<std::unique_ptr<TriangleSource>> {
    Result<std::unique_ptr<TriangleSource>> opened = open();
    if (!opened.ok()) return opened;
    if (core::Status kept = opened.value()->keep_items(items); !kept.ok()) return kept.error();
    return opened;
  };
  return {};
}

// Booleans are evaluated slice by slice; a file without any is an ordinary mesh.
Result<OpenedPart> open_sif(InputFile file, MeshInput input, const core::Settings& settings,
                            const OpenOptions& options) {
  Result<std::unique_ptr<ShellTree>> tree = read_sif(std::move(file));
  if (!tree.ok()) return tree.error();
  if (!tree.value()->is_plain()) {
    return open_booleans(std::move(tree).value(), settings, options);
  }
  input.triangles = plain_triangles(std::move(tree).value());
  return open_transformed(std::move(input), settings, options);
}

OpenedPart with_warnings(OpenedPart part, std::vector<std::string> texts) {
  if (texts.empty()) return part;
  const auto append = [texts = std::move(texts)](PartSummary& summary) {
    summary.warnings.insert(summary.warnings.end(), texts.begin(), texts.end());
  };
  if (!part.read_rest) {
    append(part.summary);
    return part;
  }
  part.read_rest = [append, read = std::move(part.read_rest)]() -> Result<PartSummary> {
    Result<PartSummary> summary = read();
    if (summary.ok()) append(summary.value());
    return summary;
  };
  return part;
}

// What the file marks for supports.
struct Marks {
  MarkCounts counts;
  std::unique_ptr<MarkedFacets> facets;  // nullptr: none, or there are no supports
};

Result<OpenedPart> marked(OpenedPart part, Marks marks, const core::Settings& settings,
                          const OpenOptions& options, const std::string& name) {
  if (!marks.counts.any()) return part;
  if (settings.supports == core::SupportPlace::kOff) {
    return with_warnings(std::move(part),
                         {name + ": " + marks.counts.text() + ": not used, since supports = off"});
  }
  std::vector<std::string> texts;
  for (const std::string& text : marks.facets->warnings)
    texts.push_back(fmt::format("{}: {}", name, text));
  Result<OpenedPart> with =
      with_marks(std::move(part), std::move(marks.facets), settings, options.sort_bytes, name);
  if (!with.ok()) return with;
  return with_warnings(std::move(with).value(), std::move(texts));
}

Result<OpenedPart> modified(OpenedPart part, std::vector<ModifierBody> bodies,
                            const core::Settings& settings, const OpenOptions& options,
                            const std::string& name) {
  if (bodies.empty()) return part;
  Result<OpenedPart> with =
      with_modifiers(std::move(part), std::move(bodies), settings, options.sort_bytes, name);
  if (!with.ok()) return with;
  std::vector<std::string> texts = std::move(with.value().modifiers_unused);
  return with_warnings(std::move(with).value(), std::move(texts));
}

// An archive holds a mesh, slices, or booleans of meshes.
Result<OpenedPart> open_zipped(InputFile file, const std::string& path,
                               const core::Settings& settings, const OpenOptions& options) {
  constexpr FileKind kKind = FileKind::kZip;
  LayerFileInput layers{file.name(), nullptr, opener(file, path, kKind, open_layers)};
  MeshInput mesh{file.name(), nullptr, opener(file, path, kKind, open_triangles)};
  Result<PartContent> opened = open_zip(std::move(file));
  if (!opened.ok()) return opened.error();
  if (auto* found = std::get_if<std::unique_ptr<LayerReader>>(&opened.value())) {
    layers.layers = std::move(*found);
    return open_layer_file(std::move(layers), settings);
  }
  const std::string name = mesh.name;
  Marks marks;
  std::vector<ModifierBody> modifiers;
  const auto with = [&](Result<OpenedPart> part) -> Result<OpenedPart> {
    if (part.ok())
      part = modified(std::move(part).value(), std::move(modifiers), settings, options, name);
    if (!part.ok()) return part;
    return marked(std::move(part).value(), std::move(marks), settings, options, name);
  };
  if (auto* tree = std::get_if<std::unique_ptr<ShellTree>>(&opened.value())) {
    marks = {(*tree)->mark_counts, std::move((*tree)->marked_facets)};
    modifiers = std::move((*tree)->modifiers);
    return with(open_booleans(std::move(*tree), settings, options));
  }
  mesh.triangles = std::get<std::unique_ptr<TriangleSource>>(std::move(opened).value());
  if (core::Status kept = keep_asked(mesh, options); !kept.ok()) return kept.error();
  marks.counts = mesh.triangles->mark_counts();
  if (settings.supports != core::SupportPlace::kOff) {
    Result<std::unique_ptr<MarkedFacets>> facets = mesh.triangles->marked_facets();
    if (!facets.ok()) return facets.error();
    marks.facets = std::move(facets).value();
  }
  Result<std::vector<ModifierBody>> bodies = mesh.triangles->modifiers();
  if (!bodies.ok()) return bodies.error();
  modifiers = std::move(bodies).value();
  return with(open_transformed(std::move(mesh), settings, options));
}

Result<OpenedPart> open_alone(const std::string& path, const core::Settings& settings,
                              const OpenOptions& options) {
  Result<InputFile> opened = InputFile::open(path);
  if (!opened.ok()) return opened.error();
  InputFile& file = opened.value();
  const std::string name = file.name();
  const Result<std::optional<GcodeKind>> ready = gcode_kind(file);
  if (!ready.ok()) return ready.error();
  if (ready.value()) {
    return core::Error{core::ErrorCode::kBadPart,
                       name +
                           ": this is G-code, which was sliced already: rind print prints it as "
                           "it is, and rind plan tells of it; for anything else name the part"};
  }
  const Result<FileKind> kind = kind_of(file);
  if (!kind.ok()) return kind.error();
  if (kind.value() == FileKind::kZip) return open_zipped(std::move(file), path, settings, options);
  if (is_layers(kind.value())) {
    LayerFileInput input{name, nullptr, opener(file, path, kind.value(), open_layers)};
    Result<std::unique_ptr<LayerReader>> layers = open_layers(kind.value(), std::move(file));
    if (!layers.ok()) return layers.error();
    input.layers = std::move(layers).value();
    return open_layer_file(std::move(input), settings);
  }
  MeshInput input{name, nullptr, opener(file, path, kind.value(), open_triangles)};
  if (kind.value() == FileKind::kSif) {
    return open_sif(std::move(file), std::move(input), settings, options);
  }
  Result<std::unique_ptr<TriangleSource>> triangles = open_triangles(kind.value(), std::move(file));
  if (!triangles.ok()) return triangles.error();
  input.triangles = std::move(triangles).value();
  return open_transformed(std::move(input), settings, options);
}

PartSummary on_raft(PartSummary summary, const core::Settings& settings) {
  if (summary.layers > 0) summary.layers += settings.raft_layers;
  if (summary.height > core::Length()) summary.height += core::raft_lift(settings);
  for (PartObject& object : summary.objects) object.height += core::raft_lift(settings);
  return summary;
}

}  // namespace

Result<OpenedPart> open_part(const std::string& path, const core::Settings& settings,
                             const OpenOptions& options) {
  Result<OpenedPart> part = open_alone(path, core::settings_above_raft(settings), options);
  if (!part.ok() || settings.raft_layers == 0) return part;
  part.value().summary = on_raft(std::move(part.value().summary), settings);
  if (!part.value().read_rest) return part;
  part.value().read_rest = [read = std::move(part.value().read_rest),
                            settings]() -> Result<PartSummary> {
    Result<PartSummary> summary = read();
    if (!summary.ok()) return summary;
    return on_raft(std::move(summary).value(), settings);
  };
  return part;
}

Result<OpenedPart> read_whole(Result<OpenedPart> part) {
  if (!part.ok() || !part.value().read_rest) return part;
  Result<PartSummary> summary = part.value().read_rest();
  if (!summary.ok()) return summary.error();
  part.value().summary = std::move(summary).value();
  part.value().read_rest = nullptr;
  return part;
}

Result<OpenedPart> open_whole_part(const std::string& path, const core::Settings& settings,
                                   const OpenOptions& options) {
  return read_whole(open_part(path, settings, options));
}

}  // namespace host
