#include "tests/support/mesh_files.h"

#include <fmt/format.h>
#include <zip.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "core/check.h"
#include "tests/support/temporary_folder.h"

namespace test {
namespace {

// Corners that are equal are one vertex; texts, so that every format has the same digits.
struct Indexed {
  std::vector<std::string> vertices;  // "x y z", parted by `separator`
  std::vector<std::array<std::size_t, 3>> triangles;
};

// What a binary STL makes of it, to all digits.
double as_float(double value) { return static_cast<double>(static_cast<float>(value)); }

Indexed indexed(const parts::Part& part, const std::string& pattern) {
  Indexed mesh;
  std::map<std::string, std::size_t> known;
  part([&](const parts::Facet& facet) {
    std::array<std::size_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [x, y, z] = facet[i];
      const std::string text =
          fmt::format(fmt::runtime(pattern), as_float(x), as_float(y), as_float(z));
      const auto [at, fresh] = known.try_emplace(text, mesh.vertices.size());
      if (fresh) mesh.vertices.push_back(text);
      corners[i] = at->second;
    }
    mesh.triangles.push_back(corners);
  });
  return mesh;
}

}  // namespace

std::string stl_file(const parts::Part& part) {
  std::ostringstream out;
  parts::write_binary_stl(part, out);
  return out.str();
}

std::string obj_file(const parts::Part& part) {
  const Indexed mesh = indexed(part, "v {} {} {}\n");
  std::string text = "# a part\nmtllib none.mtl\no part\n";
  for (const std::string& vertex : mesh.vertices) text += vertex;
  for (const auto& [a, b, c] : mesh.triangles) {
    text += fmt::format("f {}//1 {}//1 {}//1\n", a + 1, b + 1, c + 1);
  }
  return text;
}

std::string amf_file(const parts::Part& part) {
  const Indexed mesh =
      indexed(part, "<vertex><coordinates><x>{}</x><y>{}</y><z>{}</z></coordinates></vertex>\n");
  std::string text =
      "<?xml version=\"1.0\"?>\n<amf unit=\"millimeter\"><object id=\"0\"><mesh>"
      "<vertices>\n";
  for (const std::string& vertex : mesh.vertices) text += vertex;
  text += "</vertices><volume>\n";
  for (const auto& [a, b, c] : mesh.triangles) {
    text += fmt::format("<triangle><v1>{}</v1><v2>{}</v2><v3>{}</v3></triangle>\n", a, b, c);
  }
  return text + "</volume></mesh></object></amf>\n";
}

std::string sif_file(const parts::Part& part) {
  const Indexed mesh = indexed(part, "(v {} {} {})\n");
  std::string text = "(SIF_SFF 2 0 (units mm)\n(solid (shell (vertices\n";
  for (const std::string& vertex : mesh.vertices) text += vertex;
  text += ") (triangles\n";
  for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("(t {} {} {})\n", a, b, c);
  return text + "))))\n";
}

std::string old_sif_file(const parts::Part& part) {
  const Indexed mesh = indexed(part, "{} {} {}");
  std::string text = "(SIF_SFF 1 0 (units (e 1 -3))\n(body (lump (shell\n";
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    text += fmt::format("(v A{} {})\n", i, mesh.vertices[i]);
  }
  for (const auto& [a, b, c] : mesh.triangles) text += fmt::format("(t A{} A{} A{})\n", a, b, c);
  return text + "))))\n";
}

std::string threemf_model(const parts::Part& part) {
  const Indexed mesh = indexed(part, "<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n");
  std::string text =
      "<?xml version=\"1.0\"?>\n<model unit=\"millimeter\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
      "<resources><object id=\"1\" type=\"model\"><mesh><vertices>\n";
  for (const std::string& vertex : mesh.vertices) text += vertex;
  text += "</vertices><triangles>\n";
  for (const auto& [a, b, c] : mesh.triangles) {
    text += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", a, b, c);
  }
  return text +
         "</triangles></mesh></object></resources><build><item objectid=\"1\"/></build>"
         "</model>\n";
}

std::string threemf_file(const std::string& model) {
  return zip_file(
      {{"_rels/.rels",
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Target=\"/3D/part.model\" Id=\"a\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
       {"3D/part.model", model}});
}

std::string two_volume_threemf_file(const std::string& roles) {
  const parts::Part both =
      parts::together({parts::box({0, 0, 0}, 4, 3, 2), parts::box({1, 1, 0}, 1, 1, 3)});
  return zip_file(
      {{"3D/3dmodel.model", threemf_model(both)}, {"Metadata/Slic3r_PE_model.config", roles}});
}

std::string negative_volume_roles() {
  return "<config><object id=\"1\"><volume firstid=\"0\" lastid=\"11\"/><volume firstid=\"12\" "
         "lastid=\"23\"><metadata type=\"volume\" key=\"volume_type\" "
         "value=\"NegativeVolume\"/></volume><part id=\"1\" subtype=\"normal_part\"/></object>"
         "<plate/></config>";
}

std::string sliced_threemf_model() {
  const auto slice = [](const std::string& ztop) {
    return "<s:slice ztop=\"" + ztop +
           "\"><s:vertices><s:vertex x=\"0\" y=\"0\"/><s:vertex x=\"8\" y=\"0\"/>"
           "<s:vertex x=\"0\" y=\"8\"/></s:vertices><s:polygon startv=\"0\"><s:segment v2=\"1\"/>"
           "<s:segment v2=\"2\"/><s:segment v2=\"0\"/></s:polygon></s:slice>";
  };
  return "<model xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\"><resources>"
         "<s:slicestack id=\"5\">" +
         slice("0.2") + slice("0.4") +
         "</s:slicestack><object id=\"1\" "
         "s:slicestackid=\"5\" s:meshresolution=\"lowres\"/></resources><build>"
         "<item objectid=\"1\"/></build></model>";
}

std::string zip_file(const std::vector<std::pair<std::string, std::string>>& entries) {
  const TemporaryFolder folder;
  const std::string path = folder.path("a.zip");
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
  RIND_CHECK(archive != nullptr);
  for (const auto& [name, content] : entries) {
    zip_source_t* source = zip_source_buffer(archive, content.data(), content.size(), 0);
    const zip_int64_t at = zip_file_add(archive, name.c_str(), source, 0);
    RIND_CHECK(at >= 0);
    // The same bytes each time.
    RIND_CHECK(zip_file_set_mtime(archive, static_cast<zip_uint64_t>(at), 1'000'000'000, 0) == 0);
  }
  RIND_CHECK(zip_close(archive) == 0);
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace test
