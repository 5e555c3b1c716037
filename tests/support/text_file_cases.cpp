#include <fmt/format.h>

#include <sstream>

#include "tests/support/file_cases.h"
#include "tests/support/mesh_files.h"

namespace test {
namespace {

constexpr double kBox = 4'000;

const std::string kVertices =
    "v 0 0 0\nv 20 0 0\nv 20 20 0\nv 0 20 0\nv 0 0 10\nv 20 0 10\nv 20 20 10\nv 0 20 10\n";
const std::string kFaces = "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

// Behind the end of each vertex's line.
std::string with_vertex_tail(const std::string& tail) {
  std::string text;
  std::istringstream lines(kVertices);
  for (std::string line; std::getline(lines, line);) text += line + tail + "\n";
  return text + kFaces;
}

// Faces by indices from the end; `slashes` behind each.
std::string from_the_end(const std::string& slashes) {
  std::string text = kVertices + "vn 0 0 1\n";
  std::istringstream words(kFaces);
  for (std::string word; words >> word;) {
    text += word == "f" ? "\nf" : fmt::format(" {}{}", std::stoi(word) - 9, slashes);
  }
  return text + "\n";
}

// Two whole polygons and a wall of quads. `upright`: the polygon is in x and z, `height` along -y.
std::string obj_prism(const std::vector<std::pair<double, double>>& polygon, double height,
                      bool upright) {
  std::string text, bottom = "f", top = "f", sides;
  const std::size_t n = polygon.size();
  for (const double level : {0.0, height}) {
    for (const auto& [x, y] : polygon) {
      text += upright ? fmt::format("v {} {} {}\n", x, 50 - level, y)
                      : fmt::format("v {} {} {}\n", x, y, level);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    bottom += fmt::format(" {}", n - i);
    top += fmt::format(" {}", n + i + 1);
    const std::size_t j = (i + 1) % n;
    sides += fmt::format("f {} {} {} {}\n", i + 1, j + 1, n + j + 1, n + i + 1);
  }
  return text + bottom + "\n" + top + "\n" + sides;
}

std::vector<FileCase> polygon_cases() {
  // The U begins at a corner from which the whole of it can't be seen.
  const std::vector<std::pair<double, double>> u{{10, 10}, {10, 30}, {0, 30},  {0, 0},
                                                 {30, 0},  {30, 30}, {20, 30}, {20, 10}};
  const std::vector<std::pair<double, double>> l{{0, 0},   {30, 0},  {30, 10},
                                                 {10, 10}, {10, 30}, {0, 30}};
  std::vector<std::pair<double, double>> comb{{0, 0}, {45, 0}};
  for (int tooth = 4; tooth >= 0; --tooth) {
    const double x = 10.0 * tooth;
    if (tooth < 4) comb.emplace_back(x + 5, 5);
    comb.emplace_back(x + 5, 20);
    comb.emplace_back(x, 20);
    if (tooth > 0) comb.emplace_back(x, 5);
  }
  std::vector<FileCase> cases = {{"L.obj", obj_prism(l, 10, false), 5'000, 50, {}},
                                 {"U.obj", obj_prism(u, 10, false), 7'000, 50, {}},
                                 {"U_standing.obj", obj_prism(u, 10, true), 7'000, 150, {}},
                                 {"comb_standing.obj", obj_prism(comb, 10, true), 6'000, 100, {}}};
  // A rib of some road's width on a plate.
  for (const double w : {0.4, 0.5, 0.6, 0.65, 0.7, 0.8, 1.0}) {
    const std::vector<std::pair<double, double>> rib{
        {0, 0},          {10, 0},         {10, 5 - w / 2}, {20, 5 - w / 2},
        {20, 5 + w / 2}, {10, 5 + w / 2}, {10, 10},        {0, 10}};
    cases.push_back({fmt::format("rib_{}.obj", w), obj_prism(rib, 2, false), 200 + 20 * w, 10, {}});
  }
  return cases;
}

std::vector<FileCase> text_stl_cases() {
  std::ostringstream out;
  parts::write_ascii_stl(case_box(), out);
  const std::string text = out.str();
  const std::string open_text = text.substr(0, text.rfind("facet normal"));  // a facet is missing
  const std::string quad =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 9 0 0\nvertex 9 9 0\n"
      "vertex 0 9 0\nendloop\nendfacet\n";
  return {
      {"text.stl", text, kBox, 50, {}},
      {"upper.stl", replaced(replaced(text, "facet", "FACET"), "vertex", "VERTEX"), kBox, 50, {}},
      {"blank_lines.stl", replaced(text, "\n", "\n\n"), kBox, 50, {}},
      {"bom.stl", "\xEF\xBB\xBF" + text, kBox, 50, {}},
      {"leading_blank.stl", "\n  " + text, kBox, 50, {}},
      {"name_with_facet.stl", replaced(text, "solid part", "solid facet of a part"), kBox, 50, {}},
      {"no_name.stl", replaced(text, "solid part", "solid"), kBox, 50, {}},
      {"two_solids.stl",
       replaced(text, "endsolid part", "endsolid\nsolid b\nendsolid"),
       kBox,
       50,
       {}},
      {"no_endsolid.stl", text.substr(0, text.rfind("endsolid")), kBox, 50, {"without 'endsolid'"}},
      {"no_endsolid_between.stl",
       text.substr(0, text.rfind("endsolid")) + "solid b\nendsolid\n",
       kBox,
       50,
       {"'endsolid' is missing"}},
      {"cut_between_facets.stl", open_text, 0, 0, {"without 'endsolid'", "cut short"}},
      {"cut_in_a_facet.stl",
       text.substr(0, text.rfind("endloop")),
       0,
       0,
       {"facet 12", "cut short"}},
      {"cut_in_a_number.stl", text.substr(0, text.rfind("vertex") + 9), 0, 0, {"facet 12"}},
      {"text_after_end.stl", text + "exported 2024, thank you\nbye\n", kBox, 50, {"line 87"}},
      {"more_behind_text.stl", text + "and now:\nsolid b\nendsolid b\n", kBox, 50, {"left out"}},
      {"facet_after_end.stl", text + quad, 0, 0, {"'facet' where 'solid'"}},
      {"comment_lines.stl",
       replaced(text, "solid part\n", "solid part\n# by hand\n"),
       0,
       0,
       {"line 2"}},
      {"decimal_comma.stl", replaced(text, " 20 ", " 20,0 "), 0, 0, {"'20,0'", "a number"}},
      {"end_facet.stl", replaced(text, "endfacet", "end facet"), 0, 0, {"'end'"}},
      {"quad_loop.stl", "solid\n" + quad + "endsolid\n", 0, 0, {"'vertex' where 'endloop'"}},
  };
}

std::vector<FileCase> binary_stl_cases() {
  const std::string binary = stl_file(case_box());
  const auto with_head = [&binary](const std::string& head) {
    return head + binary.substr(head.size());
  };
  const auto with_count = [&binary](const std::string& four) {
    return binary.substr(0, 80) + four + binary.substr(84);
  };
  return {
      {"binary.stl", binary, kBox, 50, {}},
      {"solid_header.stl", with_head("solid by a program"), kBox, 50, {}},
      {"solid_header_newline.stl", with_head("solid a\nb\n"), kBox, 50, {}},
      {"count_zero.stl", with_count(std::string(4, '\0')), kBox, 50, {"counts 0 facets"}},
      {"count_minus1.stl", with_count("\xFF\xFF\xFF\xFF"), kBox, 50, {"the file has 12"}},
      {"count_more.stl", with_count(std::string("\x0D\0\0\0", 4)), kBox, 50, {"counts 13 facets"}},
      {"count_fewer.stl", with_count(std::string("\x05\0\0\0", 4)), kBox, 50, {"counts 5 facets"}},
      {"trailing_bytes.stl", binary + std::string(30, 'x'), kBox, 50, {"goes on after"}},
      {"cut_at_a_facet.stl",
       binary.substr(0, binary.size() - 100),
       0,
       0,
       {"counts 12 facets, the file has 10", "cut short"}},
      {"cut_in_mid_facet.stl",
       binary.substr(0, binary.size() - 70),
       0,
       0,
       {"facet 11", "cut short"}},
  };
}

}  // namespace

std::vector<FileCase> obj_cases() {
  const std::string box = kVertices + kFaces;
  std::vector<FileCase> cases = {
      {"quads.obj", box, kBox, 50, {}},
      {"no_last_newline.obj", box.substr(0, box.size() - 1), kBox, 50, {}},
      {"tabs.obj", replaced(box, " ", "\t"), kBox, 50, {}},
      {"cr_only.obj", replaced(box, "\n", "\r"), kBox, 50, {}},
      {"bom_crlf.obj", "\xEF\xBB\xBF# x\r\n" + replaced(box, "\n", "\r\n"), kBox, 50, {}},
      {"vertex_colours.obj", with_vertex_tail(" 0.5 0.25 1.0"), kBox, 50, {}},
      {"vertex_w.obj", with_vertex_tail(" 1.0"), kBox, 50, {}},
      {"colours_in_next_line.obj", with_vertex_tail(" \\\n 0.5 0.25 1.0"), kBox, 50, {}},
      {"negative.obj", from_the_end(""), kBox, 50, {}},
      {"negative_slashes.obj", from_the_end("//-1"), kBox, 50, {}},
      {"continuation.obj",
       replaced(replaced(box, "v 20 20 0", "v 20 20 \\\n0"), "f 5 6 7 8", "f 5 6 \\\r\n7 8"),
       kBox,
       50,
       {}},
      {"continued_twice.obj", replaced(box, "f 5 6 7 8", "f 5 \\ \n 6 7\\\n 8"), kBox, 50, {}},
      {"joined_to_an_empty_line.obj", replaced(box, "f 5 6 7 8", "f 5 6 7 8 \\\n"), kBox, 50, {}},
      {"line_elements.obj", box + "l 1 2 3\np 1\n", kBox, 50, {}},
      {"latin1_name.obj", "o W\xFCrfel\n" + box, kBox, 50, {}},
      {"utf8_name.obj", "o W\xC3\xBCrfel\n" + box, kBox, 50, {}},
      {"empty_group.obj", "g\n" + box, kBox, 50, {}},
      {"backslash_in_comment.obj", "# head\\Solid\n" + box, kBox, 50, {}},
      {"comment_ends_in_backslash.obj", "# exported from C:\\parts\\\n" + box, kBox, 50, {}},
      // The first vertex once more at the end: swallowed, it would only be another part.
      {"spare_vertex.obj",
       "# exported from C:\\parts\\\n" + kVertices + "v 0 0 0\n" + kFaces,
       kBox,
       50,
       {}},
      {"library_ends_in_backslash.obj",
       "mtllib C:\\lib\\\n" + kVertices + "usemtl red\\\n" + kFaces,
       kBox,
       50,
       {}},
      {"comment_behind_a_face.obj", replaced(box, "f 5 6 7 8", "f 5 6 7 8 # top\\"), kBox, 50, {}},
      {"backslash_in_mid_line.obj", replaced(box, "f 5 6 7 8", "f 5 6 \\ 7 8"), 0, 0, {"line 10"}},
      {"long_comment.obj", "#" + std::string(6'000, 'x') + "\n" + box, kBox, 50, {}},
      {"very_long_comment.obj", "#" + std::string(300'000, 'x') + "\n" + box, kBox, 50, {}},
      {"unknown_first_words.obj", "# x\nbevel on\nc_interp off\n" + box, kBox, 50, {}},
      {"faces_first.obj", kFaces + kVertices, kBox, 50, {}},
      {"face_between.obj", "v 0 0 0\n" + kFaces + kVertices.substr(8), kBox, 50, {}},
      {"faces_first_one_missing.obj",
       kFaces + kVertices.substr(0, kVertices.size() - 10),
       0,
       0,
       {"line 2", "vertex 8 of 7"}},
      {"degenerate_face.obj", box + "f 1 2\nf 3\n", kBox, 50, {"2 faces", "line 15"}},
      {"only_degenerate_faces.obj", kVertices + "f 1 2\nf\n", 0, 0, {"no face"}},
      {"decimal_comma.obj", replaced(box, "v 20 ", "v 20,5 "), 0, 0, {"line 2", "'20,5'"}},
      {"vertex_zero.obj", box + "f 0 1 2\n", 0, 0, {"line 15", "vertex 0"}},
  };
  std::string header;
  for (int i = 0; i < 200; ++i) header += fmt::format("# material {} is of no use here\n", i);
  cases.push_back({"many_comments.obj", header + box, kBox, 50, {}});
  for (FileCase& one : polygon_cases()) cases.push_back(std::move(one));
  return cases;
}

std::vector<FileCase> amf_cases() {
  const std::string box = amf_file(case_box());
  const auto in_unit = [&](const std::string& unit) {
    return replaced(box, "unit=\"millimeter\"", "unit=\"" + unit + "\"");
  };
  const std::string in_inches = amf_file(parts::box({0, 0, 0}, 20 / 25.4, 20 / 25.4, 10 / 25.4));
  const std::string two = replaced(
      box, "</object></amf>",
      "</object><constellation id=\"1\"><instance objectid=\"0\"><rz>0</rz></instance>"
      "<instance objectid=\"0\"><deltax>60</deltax><rz>90</rz></instance></constellation></amf>");
  // Another box, as a volume of its own, and of what kind it is.
  const auto second_volume = [](const std::string& type, const std::string& value) {
    std::string text = amf_file(parts::together({case_box(), parts::box({40, 0, 0}, 10, 10, 10)}));
    std::size_t at = 0;
    for (int i = 0; i < 12; ++i) at = text.find("</triangle>", at) + 11;
    text.insert(at, "</volume><volume><metadata type=\"" + type + "\">" + value + "</metadata>");
    return text;
  };
  std::vector<FileCase> cases = {
      {"plain.amf", box, kBox, 50, {}},
      {"caps.amf", in_unit("Millimeter"), kBox, 50, {}},
      {"all_caps.amf", in_unit("MILLIMETER"), kBox, 50, {}},
      {"short.amf", in_unit(" mm "), kBox, 50, {}},
      {"british.amf", in_unit("Millimetres"), kBox, 50, {}},
      {"inch.amf", replaced(in_inches, "millimeter", "Inch"), kBox, 50, {}},
      {"unknown_unit.amf", in_unit("parsec"), 0, 0, {"'parsec'"}},
      {"constellation.amf", two, 2 * kBox, 50, {}},
      {"modifier.amf", second_volume("slic3r.modifier", "1"), kBox, 50, {"modifiers"}},
      {"modifier_type.amf",
       second_volume("slic3r.volume_type", "ParameterModifier"),
       kBox,
       50,
       {"modifiers"}},
      {"second_part.amf", second_volume("slic3r.volume_type", "ModelPart"), kBox + 1'000, 50, {}},
      {"negative.amf", second_volume("slic3r.volume_type", "NegativeVolume"), 0, 0, {"export 3MF"}},
  };
  for (const std::string entry : {"same.amf", "OTHER.AMF", "model", "model.xml", "a/b.amf"}) {
    cases.push_back(
        {"zipped_" + replaced(entry, "/", "_") + ".amf", zip_file({{entry, box}}), kBox, 50, {}});
  }
  return cases;
}

std::vector<FileCase> stl_cases() {
  std::vector<FileCase> cases = text_stl_cases();
  for (FileCase& one : binary_stl_cases()) cases.push_back(std::move(one));
  return cases;
}

}  // namespace test
