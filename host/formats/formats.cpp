#include "host/formats/formats.h"

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "core/check.h"                    // RIND_CHECK
#include "host/formats/amf_reader.h"       // open_amf
#include "host/formats/cli_reader.h"       // open_cli
#include "host/formats/lsif_reader.h"      // open_lsif
#include "host/formats/obj_reader.h"       // open_obj
#include "host/formats/sif_reader.h"       // read_sif
#include "host/formats/slc_reader.h"       // open_slc
#include "host/formats/slice_v0_reader.h"  // open_slice_v0
#include "host/formats/stl.h"              // StlReader
#include "host/formats/svg_reader.h"       // open_svg
#include "host/formats/threemf_reader.h"   // open_threemf
#include "host/formats/xml_file_bytes.h"   // xml_bytes_of
#include "host/formats/zip_archive.h"      // ZipArchive
#include "host/formats/zip_part.h"         // only_part

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

// Depth of archives: a 3MF, itself an archive, may be in a zip file.
constexpr int kZipDepthMax = 2;

constexpr std::array kFormats = {
    FormatRow{"STL", ".stl", "mesh", true, false, "binary and ASCII"},
    FormatRow{"3MF", ".3mf", "mesh", true, false,
              "items, components, negative parts; slices; marks for supports"},
    FormatRow{"OBJ", ".obj", "mesh", true, false, "in mm"},
    FormatRow{"AMF", ".amf", "mesh", true, false, "XML or zipped"},
    FormatRow{"zip", ".zip", "mesh", true, false, "with one part of a kind that is read"},
    FormatRow{"CLI 2.0", ".cli", "layers", true, true, "ASCII and binary; walls or slices"},
    FormatRow{"CLI roads", ".cli", "roads", false, true, "each road as hatches"},
    FormatRow{"SIF", ".sif", "mesh", true, false, "2.0 with booleans; 1.0: triangles, instances"},
    FormatRow{"L-SIF", ".lsif", "layers", true, true, "booleans in and out"},
    FormatRow{"SLC 2.0", ".slc", "layers", true, false, "3D Systems"},
    FormatRow{"Slice V0", ".ssl .slc", "layers", true, true, "Stratasys, ASCII, inches"},
    FormatRow{"SVG layers", ".svg", "layers", true, true, "Slic3r's two dialects"},
    FormatRow{"G-code", ".gcode", "roads", true, true, "print: as it is; slice writes it"},
    FormatRow{"binary G-code", ".bgcode", "roads", true, false, "Prusa's; print: as it is"},
};

Error not_as_before(const std::string& name) {
  return {ErrorCode::kBadPart, name + ": the file has changed while it was read; try again"};
}

Result<PartContent> open_archive(InputFile file, int depth) {
  Result<ZipArchive> archive = ZipArchive::open(std::move(file));
  if (!archive.ok()) return archive.error();
  if (is_threemf(archive.value())) return open_threemf(std::move(archive).value());
  Result<InputFile> part = only_part(archive.value());
  if (!part.ok()) return part.error();
  const Result<FileKind> kind = kind_of(part.value());
  if (!kind.ok()) return kind.error();
  if (kind.value() == FileKind::kZip) {
    if (depth < kZipDepthMax) return open_archive(std::move(part).value(), depth + 1);
    return Error{ErrorCode::kBadPart,
                 part.value().name() + ": zip archives within one another; unpack them first"};
  }
  if (kind.value() == FileKind::kSif) {
    Result<std::unique_ptr<ShellTree>> tree = read_sif(std::move(part).value());
    if (!tree.ok()) return tree.error();
    if (!tree.value()->is_plain()) return PartContent(std::move(tree).value());
    return PartContent(plain_triangles(std::move(tree).value()));
  }
  if (is_layers(kind.value())) {
    Result<std::unique_ptr<LayerReader>> layers =
        open_layers(kind.value(), std::move(part).value());
    if (!layers.ok()) return layers.error();
    return PartContent(std::move(layers).value());
  }
  Result<std::unique_ptr<TriangleSource>> mesh =
      open_triangles(kind.value(), std::move(part).value());
  if (!mesh.ok()) return mesh.error();
  return PartContent(std::move(mesh).value());
}

}  // namespace

Result<PartContent> open_zip(InputFile file) { return open_archive(std::move(file), 1); }

std::span<const FormatRow> formats() { return kFormats; }

bool is_layers(FileKind kind) {
  switch (kind) {
    case FileKind::kStl:
    case FileKind::kZip:
    case FileKind::kAmf:
    case FileKind::kObj:
    case FileKind::kSif:
      return false;
    case FileKind::kLsif:
    case FileKind::kCli:
    case FileKind::kSlc:
    case FileKind::kSliceV0:
    case FileKind::kSvg:
      return true;
  }
  return false;
}

Result<std::unique_ptr<LayerReader>> open_layers(FileKind kind, InputFile file) {
  RIND_CHECK(is_layers(kind) || kind == FileKind::kZip);
  switch (kind) {
    case FileKind::kZip: {
      const std::string name = file.name();
      Result<PartContent> opened = open_zip(std::move(file));
      if (!opened.ok()) return opened.error();
      auto* layers = std::get_if<std::unique_ptr<LayerReader>>(&opened.value());
      if (layers == nullptr) return not_as_before(name);
      return std::move(*layers);
    }
    case FileKind::kLsif:
      return open_lsif(std::move(file));
    case FileKind::kSlc:
      return open_slc(std::move(file));
    case FileKind::kSliceV0:
      return open_slice_v0(std::move(file));
    case FileKind::kSvg:
      return open_svg(std::move(file));
    default:
      return open_cli(std::move(file));
  }
}

Result<std::unique_ptr<TriangleSource>> open_triangles(FileKind kind, InputFile file) {
  RIND_CHECK(!is_layers(kind));
  if (kind == FileKind::kSif) {
    Result<std::unique_ptr<ShellTree>> tree = read_sif(std::move(file));
    if (!tree.ok()) return tree.error();
    RIND_CHECK(tree.value()->is_plain());
    return plain_triangles(std::move(tree).value());
  }
  if (kind == FileKind::kZip) {
    const std::string name = file.name();
    Result<PartContent> opened = open_zip(std::move(file));
    if (!opened.ok()) return opened.error();
    auto* mesh = std::get_if<std::unique_ptr<TriangleSource>>(&opened.value());
    if (mesh == nullptr) return not_as_before(name);
    return std::move(*mesh);
  }
  if (kind == FileKind::kObj) return open_obj(std::move(file));
  if (kind == FileKind::kAmf) {
    std::string name = file.name();
    return open_amf(std::move(name), xml_bytes_of(std::move(file)));
  }
  Result<std::unique_ptr<StlReader>> reader = StlReader::open(std::move(file));
  if (!reader.ok()) return reader.error();
  return std::unique_ptr<TriangleSource>(std::move(reader).value());
}

}  // namespace host
