#include "tests/support/marked_files.h"

#include <fmt/format.h>

#include <cstddef>

#include "tests/support/mesh_files.h"  // zip_file

namespace test {
namespace {

// <mesh> of some bodies, each facet with corners of its own. `attribute`: of what is painted.
std::string mesh_of(const std::vector<MarkedBody>& bodies, const std::string& attribute) {
  std::string vertices, triangles;
  std::int64_t corners = 0;
  for (const MarkedBody& body : bodies) {
    std::int64_t number = 0;
    body.part([&](const parts::Facet& facet) {
      for (const parts::Corner& at : facet) {
        vertices += fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>", at.x, at.y, at.z);
      }
      const std::string paint = body.paint ? body.paint(number) : "";
      triangles += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"{}/>\n", corners,
                               corners + 1, corners + 2,
                               paint.empty() ? "" : fmt::format(" {}=\"{}\"", attribute, paint));
      corners += 3;
      ++number;
    });
  }
  return "<mesh><vertices>" + vertices + "</vertices><triangles>\n" + triangles +
         "</triangles></mesh>";
}

std::string model(const std::string& resources, const std::string& build) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" "
         "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:slic3rpe=\"http://schemas.slic3r.org/3mf/2017/06\"><resources>" +
         resources + "</resources><build>" + build + "</build></model>";
}

std::string object(std::size_t id, const std::string& content) {
  return fmt::format("<object id=\"{}\" type=\"model\">{}</object>", id, content);
}

std::string settings_of(const BodySettings& settings, const std::string& type) {
  std::string text;
  for (const auto& [key, value] : settings) {
    text += fmt::format("<metadata {}key=\"{}\" value=\"{}\"/>", type, key, value);
  }
  return text;
}

std::string package(const std::string& model, const std::string& entry, const std::string& roles) {
  return zip_file(
      {{"3D/3dmodel.model", model},
       {entry, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<config>" + roles + "</config>"}});
}

}  // namespace

std::string prusa_threemf(const std::vector<MarkedBody>& bodies,
                          const std::vector<std::string>& transforms,
                          const BodySettings& of_object) {
  std::string roles = "<object id=\"1\" instances_count=\"1\">", items;
  roles += settings_of(of_object, "type=\"object\" ");
  std::int64_t first = 0;
  for (const MarkedBody& body : bodies) {
    const std::int64_t count = parts::count_facets(body.part);
    roles += fmt::format(
        "<volume firstid=\"{}\" lastid=\"{}\"><metadata type=\"volume\" key=\"volume_type\" "
        "value=\"{}\"/>{}</volume>",
        first, first + count - 1, body.type, settings_of(body.settings, "type=\"volume\" "));
    first += count;
  }
  for (const std::string& transform : transforms) {
    items += "<item objectid=\"1\"" +
             (transform.empty() ? "" : " transform=\"" + transform + "\"") + "/>";
  }
  return package(model(object(1, mesh_of(bodies, "slic3rpe:custom_supports")), items),
                 "Metadata/Slic3r_PE_model.config", roles + "</object>");
}

std::string named_threemf(const std::vector<NamedItem>& items) {
  std::string objects, build;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const NamedItem& item = items[i];
    objects += fmt::format("<object id=\"{}\" type=\"model\" name=\"{}\">{}</object>", i + 1,
                           item.name, mesh_of({{item.part, "ModelPart"}}, "paint"));
    build +=
        fmt::format("<item objectid=\"{}\"{}/>", i + 1,
                    item.transform.empty() ? "" : fmt::format(" transform=\"{}\"", item.transform));
  }
  return zip_file({{"3D/3dmodel.model", model(objects, build)}});
}

std::string orca_threemf(const std::vector<MarkedBody>& bodies, const BodySettings& of_object) {
  const std::size_t whole = bodies.size() + 1;
  std::string objects, components, roles;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    objects += object(i + 1, mesh_of({bodies[i]}, "paint_supports"));
    components += fmt::format("<component objectid=\"{}\"/>", i + 1);
    roles += fmt::format("<part id=\"{}\" subtype=\"{}\">{}</part>", i + 1, bodies[i].type,
                         settings_of(bodies[i].settings, ""));
  }
  objects += object(whole, "<components>" + components + "</components>");
  return package(
      model(objects, fmt::format("<item objectid=\"{}\"/>", whole)),
      "Metadata/model_settings.config",
      fmt::format("<object id=\"{}\">{}{}</object>", whole, settings_of(of_object, ""), roles));
}

}  // namespace test
