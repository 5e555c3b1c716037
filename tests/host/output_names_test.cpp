// The program never writes over what it reads, nor over what a name can't have been meant for.
#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/part_folder.h"
#include "tests/support/run_program.h"

namespace fs = std::filesystem;
using test::content;
using test::PartFolder;
using test::ProgramRun;
using test::rind;
using test::says;

namespace {

const std::string kCoarse = " --quiet --layer-height 0.4 --wall-thickness 0.8";

std::set<std::string> names_in(const PartFolder& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.file(""))) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

parts::Part small_box() { return parts::box({1, 1, 0}, 8, 6, 4); }

}  // namespace

TEST_CASE("no option writes over the part or the profile, by whatever name") {
  const PartFolder folder;
  const std::string part = folder.add("part.stl", small_box());
  const std::string profile = folder.add_text("own.ini", "layer_height = 0.4\n");
  fs::create_symlink("part.stl", folder.file("soft.gcode"));
  fs::create_hard_link(part, folder.file("hard.gcode"));
  fs::create_directory(folder.file("sub"));
  fs::create_symlink("../own.ini", folder.file("sub/profile.gcode"));
  const std::string before = content(part), profile_before = content(profile);
  const std::set<std::string> names = names_in(folder);
  const std::vector<std::string> inputs = {part,
                                           folder.file("./part.stl"),
                                           folder.file("sub/../part.stl"),
                                           folder.file("soft.gcode"),
                                           folder.file("hard.gcode"),
                                           profile,
                                           folder.file("sub/profile.gcode")};
  const std::string other = folder.file("other.gcode");
  const std::string read = part + " --profile " + profile + kCoarse;
  for (const std::string& input : inputs) {
    CAPTURE(input);
    for (const std::string& arguments :
         {"slice " + read + " --format gcode -o " + input,
          "slice " + read + " -o " + other + " --stats " + input,
          "slice " + read + " -o " + other + " --log " + input,
          "plan " + read + " --stats " + input, "plan " + read + " --log " + input,
          "show " + read + " --layer 1 -o " + folder.file("a.svg") + " --stats " + input,
          "print " + read + " --port virtual --virtual-speed 0 --stats " + input,
          "print " + read + " --port virtual --virtual-speed 0 --log " + input}) {
      CAPTURE(arguments);
      const ProgramRun run = rind(arguments);
      CAPTURE(run.output);
      CHECK_EQ(run.exit_code, 3);
      CHECK(says(run, "itself, which would be lost"));
    }
  }
  CHECK_EQ(rind("slice - --format gcode -o " + part + kCoarse + " < " + part).exit_code, 3);
  CHECK_EQ(rind("slice " + part + " --format gcode -o -" + kCoarse + " >> " + part).exit_code, 3);
  CHECK_EQ(content(part), before);
  CHECK_EQ(content(profile), profile_before);
  CHECK(names_in(folder) == names);
}

TEST_CASE("two outputs never share a file") {
  const PartFolder folder;
  const std::string part = folder.add("part.stl", small_box());
  const std::string out = folder.file("out.gcode"), log = folder.file("rind.log");
  const std::string slice = "slice " + part + kCoarse + " -o " + out;
  CHECK_EQ(rind(slice + " --stats " + out).exit_code, 3);
  CHECK_EQ(rind(slice + " --log " + folder.file("./out.gcode")).exit_code, 3);
  CHECK_EQ(rind(slice + " --stats " + log + " --log " + log).exit_code, 3);
  // Where the log's older part will be.
  CHECK_EQ(rind(slice + " --stats " + folder.file("rind.1.log") + " --log " + log).exit_code, 3);
  CHECK_EQ(rind("plan " + part + kCoarse + " --stats " + out + " > " + out).exit_code, 3);
  CHECK_EQ(rind(slice + " --stats " + folder.file("s.json") + " --log " + log).exit_code, 0);
}

TEST_CASE("a file of another kind is not replaced, one of the same kind is") {
  const PartFolder folder;
  const std::string part = folder.add("part.stl", small_box());
  const std::string other = folder.add("other.stl", small_box());
  std::ostringstream ascii;
  parts::write_ascii_stl(small_box(), ascii);
  const std::vector<std::string> precious = {
      other,
      folder.add_text("ascii.stl", ascii.str()),
      folder.add_text("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
      folder.add_text("archive.3mf", "PK\x03\x04 and more"),
      folder.add_text("settings.ini", "layer_height = 0.4\n"),
      folder.add_text("photo.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16))};
  for (const std::string& path : precious) {
    CAPTURE(path);
    const std::string before = content(path);
    const std::string out = folder.file("out.gcode");
    CHECK_EQ(rind("slice " + part + kCoarse + " --format gcode -o " + path).exit_code, 3);
    CHECK_EQ(rind("slice " + part + kCoarse + " --format cli-binary -o " + path).exit_code, 3);
    CHECK_EQ(rind("slice " + part + kCoarse + " -o " + out + " --stats " + path).exit_code, 3);
    CHECK_EQ(rind("plan " + part + kCoarse + " --log " + path).exit_code, 3);
    CHECK_EQ(content(path), before);
    CHECK_FALSE(fs::exists(out));
  }
  const std::string notes = folder.add_text("notes.txt", "dear diary\n");
  CHECK_EQ(rind("plan " + part + kCoarse + " --log " + notes).exit_code, 3);
  CHECK_EQ(content(notes), "dear diary\n");
  for (const char* name : {"a.gcode", "a.cli", "a.lsif", "a.ssl", "a.svg"}) {
    CAPTURE(name);
    const std::string slice = "slice " + part + kCoarse + " -o " + folder.file(name);
    for (int i = 0; i < 2; ++i) {
      const ProgramRun run = rind(slice);
      CAPTURE(run.output);
      CHECK_EQ(run.exit_code, 0);
    }
  }
  CHECK_EQ(rind("show " + part + kCoarse + " --layer 2 -o " + folder.file("a.svg")).exit_code, 0);
  const ProgramRun picture = rind("show " + part + " --layer 2 -o " + folder.file("a.jpg"));
  CHECK_EQ(picture.exit_code, 2);
  CHECK(says(picture, ".svg or .png"));
  CHECK_FALSE(fs::exists(folder.file("a.jpg")));
}

TEST_CASE("a picture's PNG replaces its own kind alone") {
  const PartFolder folder;
  const std::string part = folder.add("part.stl", small_box());
  const std::string png = folder.file("a.png");
  const std::string show = "show " + part + kCoarse;
  CHECK_EQ(rind(show + " --layer 2 -o " + png).exit_code, 0);
  const std::string first = content(png);
  CHECK(first.starts_with("\x89PNG\r\n\x1a\n"));
  CHECK(first.ends_with("\xAE\x42\x60\x82"));  // of its last chunk, which is always the same
  CHECK_EQ(rind(show + " --section Y=50% -o " + png).exit_code, 0);
  CHECK_NE(content(png), first);
  CHECK_EQ(rind(show + " --section Y=50% --zoom 2,2,2 -o " + png).exit_code, 0);
  const std::string photo =
      folder.add_text("photo.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16));
  for (const std::string& other : {photo, part}) {
    const std::string before = content(other);
    CHECK_NE(rind(show + " --layer 2 -o " + other).exit_code, 0);
    CHECK_EQ(content(other), before);
  }
}

TEST_CASE("standard output that can't be written is an error for whoever shows something there") {
  const PartFolder folder;
  const std::string part = folder.add("part.stl", small_box());
  for (const std::string& arguments :
       {"plan " + part, "plan " + part + " --json", std::string("settings"),
        std::string("settings --json"), std::string("formats"), std::string("formats --json"),
        std::string("ports"), "show " + part + " --layer 2 -o -",
        "show " + part + " --section Y=50% -o -", "slice " + part + " -o -",
        "slice " + part + " -o /dev/stdout", std::string("--help"), std::string("--version")}) {
    for (const char* where : {" > /dev/full", " >&-"}) {
      CAPTURE(arguments);
      CAPTURE(where);
      const ProgramRun run = rind(arguments + where);
      CAPTURE(run.output);
      CHECK_EQ(run.exit_code, 3);
    }
  }
  // Without standard error, no message gets into the file.
  const std::string out = folder.file("out.gcode"), whole = folder.file("whole.gcode");
  const std::string slice = "slice " + part + " --layer-height 0.4 --wall-thickness 0.8 -o ";
  CHECK_EQ(rind(slice + out + " 2>&- >&- <&-").exit_code, 0);
  CHECK_EQ(rind(slice + whole).exit_code, 0);
  CHECK_EQ(content(out), content(whole));
}
