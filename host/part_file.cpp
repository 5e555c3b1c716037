#include "host/part_file.h"

#include <memory>
#include <utility>

#include "host/formats/stl.h"      // StlReader
#include "host/input_file.h"       // InputFile
#include "host/mesh_layers.h"      // open_mesh
#include "host/triangle_source.h"  // TriangleSource

namespace host {
namespace {

using core::Result;

Result<std::unique_ptr<TriangleSource>> open_triangles(InputFile file) {
  Result<std::unique_ptr<StlReader>> reader = StlReader::open(std::move(file));
  if (!reader.ok()) return reader.error();
  return std::unique_ptr<TriangleSource>(std::move(reader).value());
}

}  // namespace

Result<OpenedPart> open_part(const std::string& path, const core::Settings& settings,
                             const OpenOptions& options) {
  Result<InputFile> file = InputFile::open(path);
  if (!file.ok()) return file.error();
  const std::string name = file.value().name();
  const bool rereadable = file.value().rereadable();
  Result<std::unique_ptr<TriangleSource>> triangles = open_triangles(std::move(file).value());
  if (!triangles.ok()) return triangles.error();
  MeshInput mesh{name, std::move(triangles).value(), {}};
  if (rereadable) {
    mesh.again = [path]() -> Result<std::unique_ptr<TriangleSource>> {
      Result<InputFile> reopened = InputFile::open(path);
      if (!reopened.ok()) return reopened.error();
      return open_triangles(std::move(reopened).value());
    };
  }
  return open_mesh(std::move(mesh), settings, options);
}

Result<OpenedPart> open_whole_part(const std::string& path, const core::Settings& settings,
                                   const OpenOptions& options) {
  Result<OpenedPart> part = open_part(path, settings, options);
  if (!part.ok() || !part.value().read_rest) return part;
  Result<PartSummary> summary = part.value().read_rest();
  if (!summary.ok()) return summary.error();
  part.value().summary = std::move(summary).value();
  part.value().read_rest = nullptr;
  return part;
}

}  // namespace host
