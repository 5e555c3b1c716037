// The table of file formats, and the functions that open them. file_kind.h recognises a file's
// kind.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/result.h"                   // Result
#include "host/files/input_file.h"         // InputFile
#include "host/formats/file_kind.h"        // FileKind
#include "host/formats/layer_reader.h"     // LayerReader
#include "host/formats/layer_writer.h"     // LayerWriter, LayerFileHead
#include "host/formats/part_content.h"     // PartContent
#include "host/formats/triangle_source.h"  // TriangleSource

namespace host {

struct FormatRow {
  const char* name;
  const char* extensions;
  const char* holds;  // "mesh", "layers", "roads"
  bool reads;
  bool writes;
  const char* remarks;
};

// The table that `rind formats` prints.
[[nodiscard]] std::span<const FormatRow> formats();

[[nodiscard]] bool is_layers(FileKind kind);
// Opens a zip archive: a 3MF package, or one part of any kind. REQUIRES: only kind_of() has read
// `file`.
[[nodiscard]] core::Result<PartContent> open_zip(InputFile file);
// REQUIRES: is_layers(kind), or a zip with layers; only kind_of() has read `file`.
[[nodiscard]] core::Result<std::unique_ptr<LayerReader>> open_layers(FileKind kind, InputFile file);
// REQUIRES: !is_layers(kind); a SIF file or an archive without booleans; only kind_of() has read
// `file`.
[[nodiscard]] core::Result<std::unique_ptr<TriangleSource>> open_triangles(FileKind kind,
                                                                           InputFile file);

}  // namespace host
