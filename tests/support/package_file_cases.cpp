#include <fmt/format.h>

#include <utility>

#include "tests/support/file_cases.h"
#include "tests/support/mesh_files.h"

namespace test {
namespace {

using parts::box;
using parts::Part;
using Entries = std::vector<std::pair<std::string, std::string>>;

constexpr double kBox = 4'000;

// <mesh> of a part, from the model that the other tests use.
std::string mesh_of(const Part& part) {
  const std::string model = threemf_model(part);
  const std::size_t begin = model.find("<mesh>"), end = model.find("</mesh>");
  return model.substr(begin, end + 7 - begin);
}

std::string object(const std::string& id, const std::string& content) {
  return "<object id=\"" + id + "\" type=\"model\">" + content + "</object>";
}

std::string item(const std::string& id, const std::string& transform = "") {
  return "<item objectid=\"" + id + "\"" +
         (transform.empty() ? "" : " transform=\"" + transform + "\"") + "/>";
}

std::string moved(double x, double y, double z) {
  return fmt::format("1 0 0 0 1 0 0 0 1 {} {} {}", x, y, z);
}

std::string model(const std::string& resources, const std::string& build,
                  const std::string& unit = "millimeter") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"" + unit +
         "\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
         "xmlns:slic3rpe=\"http://schemas.slic3r.org/3mf/2017/06\" "
         "xmlns:slic3r=\"http://schemas.slic3r.org/3mf/2017/06\"><resources>" +
         resources + "</resources><build>" + build + "</build></model>";
}

std::string relationships(const std::string& target) {
  return "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
         "<Relationship Target=\"" +
         target +
         "\" Id=\"a\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
         "</Relationships>";
}

std::string package(const std::string& main_model, const Entries& others = {}) {
  Entries entries{{"_rels/.rels", relationships("/3D/3dmodel.model")},
                  {"3D/3dmodel.model", main_model}};
  entries.insert(entries.end(), others.begin(), others.end());
  return zip_file(entries);
}

std::string component(const std::string& id, const std::string& more = "") {
  return "<component objectid=\"" + id + "\" " + more + "/>";
}

// A box, and what a slicer says the second body in it is.
constexpr double kCut = 3'360;  // of 4000, with 8 × 8 mm cut through
Part cutter() { return box({6, 6, -1}, 8, 8, 22); }

std::string settings(const std::string& object, const std::string& part_roles,
                     const std::string& more = "") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<config><object id=\"" + object +
         "\"><metadata key=\"name\" value=\"a plate\"/>" + part_roles + "</object>" + more +
         "</config>";
}

std::string part_role(const std::string& id, const std::string& subtype) {
  return "<part id=\"" + id + "\" subtype=\"" + subtype +
         "\"><metadata key=\"name\" value=\"x\"/>" +
         "<metadata key=\"matrix\" value=\"1 0 0 5 0 1 0 5 0 0 1 5 0 0 0 1\"/></part>";
}

// As Bambu Studio and OrcaSlicer write it: components in a part of the package of their own.
std::string bambu(const std::string& roles, const std::string& build = item("3"),
                  const std::string& path = "3D/Objects/a 1.model", const std::string& more = "") {
  const std::string place = "p:path=\"/" + path + "\"";
  return package(
      model(object("3", "<components>" + component("1", place) + component("2", place) +
                            "</components>"),
            build),
      {{path, model(object("1", mesh_of(case_box())) + object("2", mesh_of(cutter())), "")},
       {"Metadata/model_settings.config", settings("3", roles, more)}});
}

// As PrusaSlicer writes it: one mesh, whose triangles belong to volumes.
std::string prusa(const std::string& second_volume, const std::string& build = item("1"),
                  const std::string& entry = "Metadata/Slic3r_PE_model.config") {
  const Part both = parts::together({case_box(), cutter()});
  return package(model(object("1", mesh_of(both)), build),
                 {{entry, settings("1",
                                   "<volume firstid=\"0\" lastid=\"11\"><metadata type=\"volume\" "
                                   "key=\"volume_type\" value=\"ModelPart\"/></volume>"
                                   "<volume firstid=\"12\" lastid=\"23\">" +
                                       second_volume + "</volume>")}});
}

std::string volume_type(const std::string& type) {
  return "<metadata type=\"volume\" key=\"matrix\" value=\"1 0 0 9 0 1 0 9 0 0 1 9 0 0 0 1\"/>"
         "<metadata type=\"volume\" key=\"volume_type\" value=\"" +
         type + "\"/>";
}

std::vector<FileCase> prusa_cases() {
  const std::string negative = volume_type("NegativeVolume");
  const std::string mirrored = item("1", "-1 0 0 0 1 0 0 0 1 100 0 0");
  return {
      {"prusa_negative.3mf", prusa(negative), kCut, 50, {}},
      {"superslicer_negative.3mf",
       prusa(negative, item("1"), "Metadata/SuperSlicer_model.config"),
       kCut,
       50,
       {}},
      {"prusa_backslash.3mf",
       prusa(negative, item("1"), "Metadata\\Slic3r_PE_model.config"),
       kCut,
       50,
       {}},
      {"prusa_part.3mf", prusa(volume_type("ModelPart")), 4'000 + 64 * 12, 110, {}},
      {"prusa_no_type.3mf", prusa(""), 4'000 + 64 * 12, 110, {}},
      {"prusa_modifier.3mf", prusa(volume_type("ParameterModifier")), kBox, 50, {"1 modifier"}},
      {"prusa_old_modifier.3mf",
       prusa("<metadata type=\"volume\" key=\"modifier\" value=\"1\"/>"),
       kBox,
       50,
       {"1 modifier"}},
      {"prusa_blocker.3mf",
       prusa(volume_type("SupportBlocker")),
       kBox,
       50,
       {"1 support blocker: not used"}},
      {"prusa_enforcer.3mf",
       prusa(volume_type("SupportEnforcer")),
       kBox,
       50,
       {"1 support enforcer: not used"}},
      {"prusa_unknown.3mf", prusa(volume_type("Sparkle")), 4'000 + 64 * 12, 110, {"'Sparkle'"}},
      {"prusa_three_copies.3mf",
       prusa(negative, item("1") + item("1", moved(40, 0, 0)) + mirrored),
       3 * kCut,
       50,
       {}},
      // The second copy stands where the first one's cutter is; it isn't cut by it.
      {"prusa_over_one_another.3mf",
       prusa(negative, item("1") + item("1", moved(8, 0, 0))),
       // 28 × 20 mm without the ends of both holes, 2 × 8 mm each.
       5'280,
       50,
       {}},
      {"prusa_turned.3mf", prusa(negative, item("1", "0 1 0 -1 0 0 0 0 1 30 5 0")), kCut, 50, {}},
      {"prusa_damaged.3mf", prusa("<metadata key="), 0, 0, {"Slic3r_PE_model.config", "line 2"}},
  };
}

std::vector<FileCase> bambu_cases() {
  const std::string body = part_role("1", "normal_part");
  const std::string negative = body + part_role("2", "negative_part");
  const std::string plates = "<plate><metadata key=\"plater_id\" value=\"1\"/></plate>";
  const std::string in_one =
      package(model(object("1", mesh_of(case_box())) + object("2", mesh_of(cutter())) +
                        object("3", "<components>" + component("1") +
                                        component("2", "transform=\"" + moved(2, 0, 0) + "\"") +
                                        "</components>") +
                        object("4", mesh_of(box({40, 0, 0}, 10, 10, 10))),
                    item("3") + item("4")),
              {{"Metadata/model_settings.config", settings("3", negative)}});
  const std::string slic3r =
      package(model(object("1", mesh_of(parts::together({case_box(), cutter()}))), item("1")));
  std::string slic3r_volumes =
      model(object("1", mesh_of(parts::together({case_box(), cutter()}))), item("1"));
  slic3r_volumes.insert(slic3r_volumes.find("</mesh>"),
                        "<slic3r:volumes><slic3r:volume ts=\"0\" te=\"11\" modifier=\"0\"/>"
                        "<slic3r:volume ts=\"12\" te=\"23\" modifier=\"1\"/></slic3r:volumes>");
  std::string painted = model(object("1", mesh_of(case_box())), item("1"));
  std::string seam_painted = painted;
  painted.insert(painted.find("<triangle ") + 10, "slic3rpe:custom_supports=\"4\" ");
  seam_painted.insert(seam_painted.find("<triangle ") + 10, "paint_seam=\"4\" ");
  return {
      {"bambu_negative.3mf", bambu(negative), kCut, 50, {}},
      {"bambu_normal.3mf", bambu(body + part_role("2", "normal_part")), 4'000 + 64 * 12, 110, {}},
      {"bambu_no_space.3mf", bambu(negative, item("3"), "3D/Objects/a_1.model"), kCut, 50, {}},
      {"bambu_modifier.3mf",
       bambu(body + part_role("2", "modifier_part")),
       kBox,
       50,
       {"1 modifier"}},
      {"bambu_blocker.3mf",
       bambu(body + part_role("2", "support_blocker")),
       kBox,
       50,
       {"support blocker"}},
      {"bambu_enforcer.3mf",
       bambu(body + part_role("2", "support_enforcer")),
       kBox,
       50,
       {"enforcer"}},
      {"bambu_two_plates.3mf",
       bambu(negative, item("3"), "3D/Objects/a.model", plates + plates),
       kCut,
       50,
       {"2 plates"}},
      {"bambu_mirrored_copy.3mf",
       bambu(negative, item("3") + item("3", "-1 0 0 0 1 0 0 0 1 60 0 0")),
       2 * kCut,
       50,
       {}},
      {"bambu_all_modifiers.3mf",
       bambu(part_role("1", "modifier_part") + part_role("2", "modifier_part")),
       0,
       0,
       {"no triangle"}},
      {"orca_one_model.3mf", in_one, kCut + 1'000, 50, {}},
      {"slic3r_modifier.3mf", package(slic3r_volumes), kBox, 50, {"1 modifier"}},
      {"slic3r_none.3mf", slic3r, 4'000 + 64 * 12, 110, {}},
      {"painted.3mf", package(painted), kBox, 50, {"1 facet painted for supports: not used"}},
      {"seam_painted.3mf", package(seam_painted), kBox, 50, {"seams", "painted on are not used"}},
  };
}

}  // namespace

std::vector<FileCase> threemf_role_cases() {
  std::vector<FileCase> cases = prusa_cases();
  for (FileCase& one : bambu_cases()) cases.push_back(std::move(one));
  return cases;
}

std::vector<FileCase> threemf_cases() {
  const std::string mesh = mesh_of(case_box()), one = object("1", mesh);
  const std::string inch = object("1", mesh_of(box({0, 0, 0}, 1, 1, 0.5)));
  const std::string metre = object("1", mesh_of(box({0, 0, 0}, 0.02, 0.02, 0.01)));
  const auto at = [&](const std::string& target, const std::string& entry) {
    return zip_file({{"_rels/.rels", relationships(target)}, {entry, model(one, item("1"))}});
  };
  std::string prefixed = model(one, item("1"));
  for (const std::string name : {"model", "resources", "object", "mesh", "vertices", "vertex ",
                                 "triangles", "triangle ", "build", "item"}) {
    for (const std::string begin : {"<", "</"}) {
      for (std::size_t from = prefixed.find(begin + name); from != std::string::npos;
           from = prefixed.find(begin + name, from + 4)) {
        prefixed.insert(from + begin.size(), "c:");
      }
    }
  }
  prefixed.replace(prefixed.find(" xmlns="), 7, " xmlns:c=");
  return {
      {"plain.3mf", package(model(one, item("1"))), kBox, 50, {}},
      {"bom.3mf", package("\xEF\xBB\xBF" + model(one, item("1"))), kBox, 50, {}},
      {"prefixed.3mf", package(prefixed), kBox, 50, {}},
      {"inches.3mf",
       package(model(inch, item("1") + item("1", moved(2, 0, 0)), "inch")),
       25.4 * 25.4 * 12.8 * 2,
       64,
       {}},
      {"metres.3mf",
       package(
           model(metre + object("2", "<components>" + component("1") +
                                         component("1", "transform=\"" + moved(0, 0, 0.01) + "\"") +
                                         "</components>"),
                 item("2"), "meter")),
       2 * kBox,
       100,
       {}},
      {"mirrored.3mf",
       package(model(one, item("1", "-1 0 0 0 1 0 0 0 1 40 0 0") + item("1", moved(-30, 0, 0)))),
       2 * kBox,
       50,
       {}},
      {"used_before.3mf",
       package(
           model(object("2", "<components>" + component("1") + "</components>") + one, item("2"))),
       kBox,
       50,
       {}},
      {"at_heights.3mf",
       package(model(one, item("1") + item("1", moved(40, 0, 15)))),
       2 * kBox,
       125,
       {"25 layers hold nothing"}},
      {"too_wide.3mf",
       package(model(one, item("1", moved(128, 128, 0)) + item("1", moved(435.2, 128, 0)))),
       0,
       0,
       {"327.2", "the bed"}},
      {"backslashes.3mf", at("/3D/3dmodel.model", "3D\\3dmodel.model"), kBox, 50, {}},
      {"backslash_target.3mf", at("\\3D\\3dmodel.model", "3D/3dmodel.model"), kBox, 50, {}},
      {"other_case.3mf", at("/3D/3dmodel.model", "3d/3DModel.MODEL"), kBox, 50, {}},
      {"escaped_space.3mf", at("/3D/my%20part.model", "3D/my part.model"), kBox, 50, {}},
      {"missing.3mf", at("/3D/other.model", "3D/3dmodel.model"), 0, 0, {"no such entry"}},
  };
}

std::vector<FileCase> zip_cases() {
  const std::string stl = stl_file(case_box()), obj = obj_file(case_box());
  const std::string threemf = package(model(object("1", mesh_of(case_box())), item("1")));
  return {
      {"stl.zip", zip_file({{"part.stl", stl}}), kBox, 50, {}},
      {"obj.zip", zip_file({{"a folder/PART.OBJ", obj}}), kBox, 50, {}},
      {"3mf.zip", zip_file({{"part.3mf", threemf}}), kBox, 50, {}},
      {"negative.zip",
       zip_file({{"part.3mf", prusa(volume_type("NegativeVolume"))}}),
       kCut,
       50,
       {}},
      {"sif.zip", zip_file({{"part.sif", sif_file(case_box())}}), kBox, 50, {}},
      {"with_pictures.zip",
       zip_file({{"readme.txt", "Print it."},
                 {"images/a.png", "\x89PNG"},
                 {"files/a.stl", stl},
                 {"__MACOSX/files/._a.stl", "x"},
                 {".DS_Store", "x"}}),
       kBox,
       50,
       {}},
      {"no_ending.zip", zip_file({{"part", stl}, {"readme", "Print it."}}), kBox, 50, {}},
      {"two.zip",
       zip_file({{"a.stl", stl}, {"b/b.obj", obj}}),
       0,
       0,
       {"2 parts", "a.stl", "b/b.obj"}},
      {"none.zip", zip_file({{"a.txt", "x"}}), 0, 0, {"without a 3MF model", "a.txt"}},
      {"nested.zip",
       zip_file({{"a.zip", zip_file({{"b.zip", zip_file({{"c.stl", stl}})}})}}),
       0,
       0,
       {"within one another"}},
      {"cut.zip", zip_file({{"part.stl", stl.substr(0, stl.size() - 100)}}), 0, 0, {"cut short"}},
  };
}

}  // namespace test
