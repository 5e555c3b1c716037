// Writes one of the project's own parts as an STL file, facet by facet:
//
//     make_part --list
//     make_part pyramid -o pyramid.stl
//     make_part tower --layers 1000000 -o - | rind print - --port virtual
#include <CLI/CLI.hpp>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <string>

#include "tools/parts/part_maker.h"

namespace {

constexpr int kUsage = 2;

void list(std::ostream& out) {
  for (const parts::NamedPart& part : parts::all_parts()) {
    out << part.name << std::string(part.name.size() < 18 ? 18 - part.name.size() : 1, ' ')
        << part.description << '\n';
  }
}

// A pipe gets the first facet at once, so the count before it is 0; a file gets the right count.
void write(const parts::Part& part, bool ascii, bool pipe, std::ostream& out) {
  if (ascii) {
    parts::write_ascii_stl(part, out);
  } else {
    parts::write_binary_stl(part, out, !pipe);
  }
  out.flush();
}

int fail(const std::string& message) {
  std::cerr << "make_part: " << message << '\n';
  return kUsage;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Writes a part as an STL file; see --list"};
  std::string name, path;
  parts::PartSizes sizes;
  bool ascii = false, list_only = false;
  app.add_option("part", name, "one of those that --list names");
  app.add_option("-o,--output", path, "file to write, - for standard output");
  app.add_option("--layers", sizes.tower.layers, "height of tower and shelves in layers of 0.2 mm")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{100'000'000}));
  app.add_option("--corners", sizes.tower.corners, "of the tower's outer contour, and of its bore")
      ->check(CLI::Range(3, 100'000));
  app.add_option("--scale", sizes.tower.scale, "the tower's, across")
      ->check(CLI::Range(0.01, 100.0));
  app.add_option("--teeth", sizes.teeth, "the comb's")->check(CLI::Range(1, 1'000'000));
  app.add_option("--columns", sizes.columns, "of pins, perforated, engraved, spikes, each way")
      ->check(CLI::Range(1, 1'000));
  app.add_option("--turns", sizes.turns, "of spiral, tubes")->check(CLI::Range(1, 1'000));
  app.add_option("--level", sizes.level, "of koch")->check(CLI::Range(0, 9));
  app.add_option("--detail", sizes.detail, "facets of vase, gyroid, figure, as a multiple")
      ->check(CLI::Range(0.05, 20.0));
  app.add_flag("--ascii", ascii, "text instead of binary");
  app.add_flag("--list", list_only, "names every part");
  CLI11_PARSE(app, argc, argv);

  if (list_only) {
    list(std::cout);
    return 0;
  }
  if (path.empty()) return fail("say where to with -o FILE; --list names the parts");
  for (const parts::NamedPart& part : parts::all_parts(sizes)) {
    if (part.name != name) continue;
    if (path == "-") {
      write(part.part, ascii, true, std::cout);
      return std::cout ? 0 : fail("standard output: can't be written");
    }
    std::ofstream file(path, std::ios::binary);
    write(part.part, ascii, false, file);
    return file ? 0 : fail(path + ": can't be written");
  }
  return fail("no part is named '" + name + "'; --list names them all");
}
