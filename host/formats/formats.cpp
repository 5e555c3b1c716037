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
#include "host/formats/text_scanner.h"     // is_blank
#include "host/formats/threemf_reader.h"   // open_threemf
#include "host/formats/xml_file_bytes.h"   // xml_bytes_of
#include "host/formats/zip_archive.h"      // ZipArchive

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

// Enough for most kinds, so that a pipe's first bytes are not waited for, and to tell a binary STL
// by its first facet, whatever its head says; and enough for all.
constexpr std::array<std::size_t, 2> kLookBytes{134, 4'096};

constexpr std::array kFormats = {
    FormatRow{"STL", ".stl", "mesh", true, false, "binary and ASCII"},
    FormatRow{"3MF", ".3mf", "mesh", true, false, "items, components, production parts; slices"},
    FormatRow{"OBJ", ".obj", "mesh", true, false, "in mm"},
    FormatRow{"AMF", ".amf", "mesh", true, false, "XML or zipped"},
    FormatRow{"CLI 2.0", ".cli", "layers", true, true, "ASCII and binary; walls or slices"},
    FormatRow{"CLI roads", ".cli", "roads", false, true, "each road as hatches"},
    FormatRow{"SIF", ".sif", "mesh", true, false, "2.0 with booleans; 1.0: triangles, instances"},
    FormatRow{"L-SIF", ".lsif", "layers", true, true, "booleans in and out"},
    FormatRow{"SLC 2.0", ".slc", "layers", true, false, "3D Systems"},
    FormatRow{"Slice V0", ".ssl .slc", "layers", true, true, "Stratasys, ASCII, inches"},
    FormatRow{"SVG layers", ".svg", "layers", true, true, "Slic3r's two dialects"},
    FormatRow{"G-code", ".gcode", "roads", false, true, "what the controller is sent"},
};

// Behind a byte order mark, blanks, and what both SIF and OBJ take as comments.
std::string_view significant(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  while (!text.empty()) {
    if (is_blank(static_cast<unsigned char>(text.front()))) {
      text.remove_prefix(1);
    } else if (text.starts_with('#')) {
      text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
    } else if (text.starts_with("(*")) {
      int open = 0;
      do {
        const bool opens = text.starts_with("(*"), closes = text.starts_with("*)");
        open += opens ? 1 : closes ? -1 : 0;
        text.remove_prefix(opens || closes ? 2 : 1);
      } while (open > 0 && !text.empty());
    } else {
      break;
    }
  }
  return text;
}

bool contains(std::string_view text, std::string_view wanted) {
  return text.find(wanted) != std::string_view::npos;
}

// "(SIF_SFF", blanks allowed behind the parenthesis.
bool begins_form(std::string_view text, std::string_view keyword) {
  if (!text.starts_with('(')) return false;
  return significant(text.substr(1)).starts_with(keyword);
}

// Words that OBJ files begin with, behind their comments.
bool begins_obj(std::string_view text) {
  const std::size_t end = text.find_first_of(" \t");
  const std::string_view word = text.substr(0, end);
  for (const char* known : {"v", "vt", "vn", "vp", "f", "o", "g", "s", "mtllib", "usemtl"}) {
    if (end != std::string_view::npos && word == known) return true;
  }
  return false;
}

bool is_text(std::string_view bytes) { return !contains(bytes, std::string_view("\0", 1)); }

// Nothing where these bytes do not tell.
std::optional<FileKind> kind_of_bytes(std::string_view bytes) {
  const std::string_view text = significant(bytes);
  if (bytes.starts_with("PK\x03\x04")) return FileKind::kZip;
  if (contains(bytes, "$$HEADERSTART")) return FileKind::kCli;
  if (contains(bytes, "-SLCVER")) return FileKind::kSlc;
  // A binary STL's 80 bytes may hold anything, what follows is no text.
  if (!is_text(bytes)) return std::nullopt;
  if (text.starts_with("Slice V0")) return FileKind::kSliceV0;
  if (begins_form(text, "LSIF")) return FileKind::kLsif;
  if (begins_form(text, "SIF_SFF")) return FileKind::kSif;
  if (text.starts_with('<')) {
    if (contains(text, "<svg")) return FileKind::kSvg;
    if (contains(text, "<amf")) return FileKind::kAmf;
  }
  if (begins_obj(text)) return FileKind::kObj;
  return std::nullopt;
}

// Kinds that are known by their first words, and refused.
std::string refusal(std::string_view bytes) {
  const std::string_view text = significant(bytes);
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    return "byte 0: text in UTF-16; save it as UTF-8 or ASCII";
  }
  for (const char* keyword : {"ASCII", "MODELER"}) {
    const std::string_view word(keyword);
    if (is_text(bytes) && text.starts_with(word) &&
        (text.size() == word.size() || is_blank(static_cast<unsigned char>(text[word.size()])))) {
      return "line 1: '" + std::string(word) +
             "' begins a QuickSlice 6 .ssl file, of which no description is public, so it can't "
             "be read; export Slice V0, CLI or STL";
    }
  }
  if (bytes.starts_with("EOS 1993 SLI FILE")) {
    return "byte 0: an EOS SLI file, which can't be read; export CLI or STL";
  }
  if (bytes.starts_with("\x1F\x8B")) return "byte 0: gzip; unpack it first: gzip -dc FILE | rind …";
  return {};
}

Error not_as_before(const std::string& name) {
  return {ErrorCode::kBadPart, name + ": the file has changed while it was read; try again"};
}

}  // namespace

Result<MeshOrLayers> open_zip(InputFile file) {
  Result<ZipArchive> archive = ZipArchive::open(std::move(file));
  if (!archive.ok()) return archive.error();
  const std::string amf = archive.value().find_ending(".amf");
  if (amf.empty()) return open_threemf(std::move(archive).value());
  Result<XmlScanner::ByteSource> bytes = archive.value().bytes_of(amf);
  if (!bytes.ok()) return bytes.error();
  Result<std::unique_ptr<TriangleSource>> mesh =
      open_amf(archive.value().name() + " (" + amf + ")", std::move(bytes).value());
  if (!mesh.ok()) return mesh.error();
  return MeshOrLayers(std::move(mesh).value());
}

std::span<const FormatRow> formats() { return kFormats; }

Result<FileKind> kind_of(InputFile& file) {
  std::string_view bytes;
  for (const std::size_t count : kLookBytes) {
    const Result<std::string_view> window = file.window(count);
    if (!window.ok()) return window.error();
    bytes = window.value().substr(0, kLookBytes.back());
    if (const std::optional<FileKind> kind = kind_of_bytes(bytes)) return *kind;
  }
  if (bytes.empty()) {
    return Error{ErrorCode::kBadPart, file.name() + ": the file is empty; export the part again"};
  }
  if (const std::string cause = refusal(bytes); !cause.empty()) {
    return Error{ErrorCode::kBadPart, file.name() + ": " + cause};
  }
  // Binary files of no other kind are STL, whose header may be anything.
  return FileKind::kStl;
}

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
      Result<MeshOrLayers> opened = open_zip(std::move(file));
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
    Result<MeshOrLayers> opened = open_zip(std::move(file));
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
