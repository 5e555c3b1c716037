#include "tests/support/format_samples.h"

#include <bit>
#include <cstdint>
#include <memory>
#include <sstream>
#include <variant>

#include "core/check.h"
#include "host/formats/formats.h"
#include "tests/support/mesh_files.h"
#include "tools/parts/part_maker.h"

namespace test {
namespace {

using core::Result;

std::string ascii_cli() {
  return "made by hand\n$$HEADERSTART\n$$ASCII // a comment // \n$$UNITS/00000000.010000\n"
         "$$VERSION/200\n$$LABEL/1,\"plate, with a hole\"\n$$DATE/220722\n"
         "$$DIMENSION/0,0,0,10.,10.,0.4\n$$LAYERS/3\n$$USERDATA/\"a,b\",3,$$x$$HEADEREND\n"
         "$$GEOMETRYSTART\n$$LAYER/0.0\n$$LAYER/20.0\n"
         "$$POLYLINE/1,1,5,0.,0.,1000.,0.,1000.,1000.,0.,1000.,0.,0.\n"
         "$$POLYLINE/1,0,5,400.,400.,400.,600.,600.,600.,600.,400.,400.,400.\n"
         "$$HATCHES/1,2,0.,0.,1.,1.,2.,2.,3.,3.\n$$POWER/3.5\n$$LAYER/40.0\n"
         "$$POLYLINE/1,2,2,0.,0.,5.,5.\n$$POLYLINE/1,1,4,0,0,900,0,0,900,0,0\n$$GEOMETRYEND\n";
}

std::string binary_cli() {
  std::string bytes = "$$HEADERSTART\r\n$$BINARY\r\n$$UNITS/0.01\r\n$$HEADEREND";
  append_u16(128, bytes);
  append_u16(20, bytes);
  append_u16(129, bytes);
  for (const unsigned number : {1U, 1U, 4U, 0U, 0U, 1000U, 0U, 0U, 1000U, 0U, 0U})
    append_u16(number, bytes);
  append_u16(127, bytes);
  append_float(40, bytes);
  append_u16(130, bytes);
  for (const std::uint32_t number : {1U, 1U, 4U}) append_u32(number, bytes);
  for (const float number : {0.F, 0.F, 1000.F, 0.F, 0.F, 1000.F, 0.F, 0.F}) {
    append_float(number, bytes);
  }
  append_u16(131, bytes);
  for (const unsigned number : {1U, 1U, 0U, 0U, 5U, 5U}) append_u16(number, bytes);
  return bytes;
}

std::string slc() {
  std::string bytes = "-SLCVER 2.0 -UNIT MM -TYPE PART -EXTENTS 0,10 0,10 0,1 \r\n\x1A";
  bytes.append(256, '\0');
  bytes += '\1';
  for (const float number : {0.F, 0.25F, 0.F, 0.F}) append_float(number, bytes);
  for (const float z : {0.F, 0.25F}) {
    append_float(z, bytes);
    append_u32(1, bytes);
    append_u32(4, bytes);
    append_u32(0, bytes);
    for (const float number : {0.F, 0.F, 8.F, 0.F, 0.F, 8.F, 0.F, 0.F}) append_float(number, bytes);
  }
  append_float(0.5F, bytes);
  append_u32(0xFFFFFFFF, bytes);
  return bytes;
}

std::string slice_v0() {
  return "Slice V0\nFILE(0,CUNITS(INCH)\nSLICES()\nZ 0.000 0.010\n0 0\n0 1\n1 1\n1 0\nC\n"
         "0.25 0.25\n0.75 0.25\n0.75 0.75\n0.25 0.75\nC\nZ 0.010 0.010\nZ 0.020 0.010\n"
         "0 0\n1 0\n0 1\nC\nEND\nignored\n";
}

std::string lsif() {
  return "(LSIF 1 0 (units mm) (desired_accuracy (e 1 -3)) (* a (* nested *) note *)\n"
         " (thickness (e 2 -1)) (offset 0) # to the end )))\n (layer\n"
         "  (v 1 0 0) (v 2 20 0) (v 3 20 20) (v 4 0 20) (v 5 5 5) (v 6 5 10) (v 7 10 10)\n"
         "  (difference (nested1d (color (rgb 1 0 0)) (contour 1 2 3 4) (contour 5 6 7))\n"
         "    (union (contour (v 8 15 15) (v 9 30 15) (v 10 30 30) 8 9 10))))\n"
         " (layer (thickness 0.3) (union)) (layer (v 1 0 0) (v 2 9 0) (v 3 0 9)\n"
         "  (intersection (contour 1 2 3) (contour 1 3 2))))\n";
}

std::string svg() {
  return "<?xml version=\"1.0\"?><svg width=\"20\" height=\"20\" "
         "xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:slic3r=\"http://slic3r.org/namespaces/slic3r\">\n"
         "<g id=\"layer0\" slic3r:z=\"0.2\" slic3r:slice-z=\"0.1\" slic3r:layer-height=\"0.2\">"
         "<path d=\"M 0 20 10 20 10 10 0 10 z M 4 16 6 16 6 14 4 14 z\"/></g>\n"
         "<g id=\"layer1\" slic3r:z=\"0.4\" slic3r:layer-height=\"0.2\">"
         "<polygon slic3r:type=\"contour\" points=\"0,0 9,0 0,9\"/></g></svg>\n";
}

parts::Part small_box() { return parts::box({0, 0, 0}, 4, 3, 2); }

std::string ascii_stl() {
  std::ostringstream out;
  parts::write_ascii_stl(small_box(), out);
  return out.str();
}

template <typename Source, typename Item>
core::Status drain(Source& source, std::size_t most, std::vector<Item>& into) {
  while (true) {
    Result<std::optional<Item>> item = source.next();
    if (!item.ok()) return item.error();
    if (!item.value()) return {};
    RIND_CHECK(into.size() < most);
    into.push_back(*std::move(item).value());
  }
}

Result<ReadFile> read_from(host::LayerReader& layers, std::size_t most) {
  ReadFile read;
  read.format = layers.format();
  if (core::Status all = drain(layers, most, read.slices); !all.ok()) return all.error();
  read.warnings = layers.warnings();
  return read;
}

// The meshes one after the other; their booleans are not evaluated.
Result<ReadFile> read_from(host::ShellTree& tree, std::size_t most) {
  ReadFile read;
  read.format = tree.format;
  read.warnings = tree.warnings;
  for (const std::vector<host::Shell>& shells : tree.operands) {
    for (const host::Shell& shell : shells) {
      const std::string cause =
          tree.store.add_item(shell.key, shell.transform, shell.reversed, shell.role);
      if (!cause.empty()) return core::Error{core::ErrorCode::kBadPart, tree.name + ": " + cause};
    }
  }
  while (true) {
    const host::MeshStore::Next next = tree.store.next();
    if (!next.error.empty()) {
      return core::Error{core::ErrorCode::kBadPart, tree.name + ": " + next.error};
    }
    if (!next.triangle) return read;
    RIND_CHECK(read.triangles.size() < most);
    read.triangles.push_back(*next.triangle);
  }
}

Result<ReadFile> read_from(host::TriangleSource& triangles, std::size_t most) {
  ReadFile read;
  read.format = triangles.format();
  if (core::Status all = drain(triangles, most, read.triangles); !all.ok()) return all.error();
  read.warnings = triangles.warnings();
  return read;
}

}  // namespace

void append_u16(unsigned number, std::string& into) {
  into += static_cast<char>(number & 0xFF);
  into += static_cast<char>(number >> 8 & 0xFF);
}

void append_u32(std::uint32_t number, std::string& into) {
  append_u16(number & 0xFFFF, into);
  append_u16(number >> 16, into);
}

void append_float(float number, std::string& into) {
  append_u32(std::bit_cast<std::uint32_t>(number), into);
}

const std::vector<FormatSample>& format_samples() {
  static const std::vector<FormatSample> samples = {
      {"ascii.cli", ascii_cli()},
      {"binary.cli", binary_cli()},
      {"3d.slc", slc()},
      {"v0.ssl", slice_v0()},
      {"layers.lsif", lsif()},
      {"layers.svg", svg()},
      {"binary.stl", stl_file(small_box())},
      {"mesh.obj", obj_file(small_box())},
      {"mesh.amf", amf_file(small_box())},
      {"mesh.3mf", threemf_file(threemf_model(small_box()))},
      {"slices.3mf", threemf_file(sliced_threemf_model())},
      {"negative.3mf", two_volume_threemf_file(negative_volume_roles())},
      {"stl.zip", zip_file({{"part.stl", stl_file(small_box())}})},
      {"new.sif", sif_file(small_box())},
      {"old.sif", old_sif_file(small_box())},
      {"ascii.stl", ascii_stl()},
  };
  return samples;
}

const std::string& format_sample(const std::string& name) {
  for (const FormatSample& sample : format_samples()) {
    if (sample.name == name) return sample.bytes;
  }
  RIND_CHECK(false);
  return format_samples()[0].bytes;
}

Result<ReadFile> read_bytes(const std::string& bytes, std::size_t most) {
  host::InputFile file = host::InputFile::from_bytes("part", bytes);
  const Result<host::FileKind> kind = host::kind_of(file);
  if (!kind.ok()) return kind.error();
  if (host::is_layers(kind.value())) {
    auto layers = host::open_layers(kind.value(), std::move(file));
    return layers.ok() ? read_from(*layers.value(), most) : Result<ReadFile>(layers.error());
  }
  if (kind.value() == host::FileKind::kZip) {
    auto opened = host::open_zip(std::move(file));
    if (!opened.ok()) return opened.error();
    return std::visit([most](const auto& found) { return read_from(*found, most); },
                      opened.value());
  }
  auto triangles = host::open_triangles(kind.value(), std::move(file));
  return triangles.ok() ? read_from(*triangles.value(), most) : Result<ReadFile>(triangles.error());
}

std::string error_of(const std::string& bytes) {
  const Result<ReadFile> read = read_bytes(bytes);
  return read.ok() ? "" : read.error().message;
}

}  // namespace test
