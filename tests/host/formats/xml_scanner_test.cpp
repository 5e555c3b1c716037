#include "host/formats/xml_scanner.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "tests/support/random_regions.h"

using host::XmlEvent;
using host::XmlScanner;

namespace {

struct Outcome {
  std::vector<std::string> starts;  // one text each, with all that an event says
  std::string error;
  bool operator==(const Outcome&) const = default;
};

// Reads `piece` bytes at once.
Outcome read(const std::string& document, std::size_t piece, bool lists) {
  std::size_t at = 0;
  XmlScanner xml(
      "a file",
      [&](char* into, std::size_t size) -> core::Result<std::size_t> {
        const std::size_t count = std::min({size, piece, document.size() - at});
        std::memcpy(into, document.data() + at, count);
        at += count;
        return count;
      },
      false);
  if (lists) xml.expect_lists({"vertices", "triangles"});
  Outcome outcome;
  while (true) {
    const core::Result<const XmlEvent*> next = xml.next();
    if (!next.ok()) {
      outcome.error = next.error().message;
      return outcome;
    }
    if (next.value() == nullptr) return outcome;
    const XmlEvent& event = *next.value();
    if (event.kind != XmlEvent::Kind::kStart) continue;
    CHECK(xml.bad("!").message == "a file: line " + std::to_string(event.line) + ": !");
    std::string text = std::to_string(event.line) + " " + event.space + " " + event.name;
    for (const auto& [name, value] : event.attributes) text += " " + name + "=" + value;
    outcome.starts.push_back(text);
  }
}

void check_alike(const std::string& document) {
  CAPTURE(document);
  const Outcome expected = read(document, document.size(), false);
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, document.size()}) {
    CAPTURE(piece);
    const Outcome with_lists = read(document, piece, true);
    CHECK(with_lists.starts == expected.starts);
    // Where a document breaks off, expat may have seen less of it.
    CHECK(with_lists.error.empty() == expected.error.empty());
  }
}

std::string model(const std::string& content, const std::string& head = "") {
  return head + "<model xmlns=\"urn:core\" xmlns:m=\"urn:m\">\n" + content + "</model>\n";
}

std::string list(const std::string& content) {
  return model("<mesh>\n<vertices>\n" + content + "</vertices>\n<triangles/></mesh>\n");
}

constexpr std::array kPieces = {
    "<vertex x=\"1\" y=\"-2.5e3\" z=\"0\"/>",
    "  <vertex  x='1'\n\ty=\"2\" z=\"3\" />\r\n",
    "\n\n",
    "<triangle v1=\"0\" v2=\"1\" v3=\"2\" paint_supports=\"4C\"></triangle>",
    "<vertex x=\"&lt;1\" y=\"a>b\" z=\"'\"/>",
    "<vertex x=\"\xC3\xA9\"/>",
    "<m:vertex x=\"1\"/>",
    "<vertex m:x=\"1\" x=\"2\"/>",
    "<vertex xmlns=\"urn:other\" x=\"1\"/>",
    "<!-- <vertex x=\"9\"/> -->",
    "<![CDATA[<vertex x=\"8\"/>]]>",
    "<?pi <vertex x=\"7\"/>?>",
    "some text",
    "<metadata><vertex x=\"6\"/></metadata>",
    "<vertex/>",
    "<vertices><vertex x=\"5\"/></vertices>",
    "\r<vertex x=\"4\"/>",
    "<vertex x=\"a\tb\" y=\"c\nd\"/>",
};

}  // namespace

TEST_CASE("plain elements of a list are read as all others are") {
  for (const char* piece : kPieces) {
    check_alike(list(piece));
    check_alike(list("<vertex x=\"1\"/>" + std::string(piece) + "\n<vertex x=\"2\"/>\n"));
  }
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    CAPTURE(seed);
    test::Random random(seed);
    std::string content;
    for (int i = random.integer(0, 12); i > 0; --i) {
      content += kPieces[static_cast<std::size_t>(random.integer(0, kPieces.size() - 1))];
    }
    check_alike(list(content));
    check_alike(model(content));
  }
}

TEST_CASE("lists of other kinds") {
  check_alike(model("<m:vertices><vertex x=\"1\"/><m:vertex x=\"2\"/></m:vertices>"));
  check_alike(model("<vertices xmlns=\"urn:here\" a=\"b\"><vertex x=\"1\"/></vertices>"));
  check_alike(model("<vertices a=\">\"><vertex x=\"1\"/></vertices>"));
  check_alike(model("<vertices/><vertex x=\"1\"/><vertices></vertices>"));
  check_alike(model("<verticesmore><vertex x=\"1\"/></verticesmore>"));
  check_alike(model("<!-- <vertices> --><vertex x=\"1\"/><vertices><vertex/></vertices>"));
  check_alike(model("<vertices " + std::string(5'000, ' ') + "><vertex x=\"1\"/></vertices>"));
  check_alike("<vertices><vertex x=\"1\"/></vertices>");
  // A document type gives attributes that are not written.
  check_alike(model("<vertices><vertex x=\"1\"/></vertices>",
                    "<!DOCTYPE model [<!ATTLIST vertex y CDATA \"7\">]>"));
}

TEST_CASE("elements longer than what is read at once, and many of them") {
  const std::string value(100'000, '7');
  check_alike(list("<vertex x=\"1\"/>\n<vertex x=\"" + value + "\"/>\n<vertex x=\"2\"/>\n"));
  std::string many;
  for (int i = 0; i < 5'000; ++i) {
    many += "  <vertex x=\"" + std::to_string(i) + "\" y=\"0.5\" z=\"-1\"/>\n";
  }
  const std::string document = list(many);
  for (const std::size_t piece : {std::size_t{1'000}, document.size()}) {
    CHECK(read(document, piece, true) == read(document, piece, false));
  }
}

TEST_CASE("what is no XML is refused, with its line") {
  for (const char* wrong :
       {"<vertex x=\"1\" x=\"2\"/>", "<vertex x=1/>", "<vertex x=\"1\"y=\"2\"/>",
        "<vertex x=\"<\"/>", "<vertex x=\"1\" / >", "<1vertex/>", "<vertex x/>",
        "<vertex x=\"1\"></vertices>", "<vertex x=\"\x01\"/>", "<vertex x=\"\xFF\"/>",
        "<vertex x=\"&no;\"/>", "& "}) {
    CAPTURE(wrong);
    const std::string document =
        list("<vertex x=\"1\"/>\n<vertex x=\"2\"/>\n" + std::string(wrong));
    const Outcome outcome = read(document, document.size(), true);
    CHECK_EQ(outcome.error, read(document, document.size(), false).error);
    CHECK(outcome.error.starts_with("a file: line 6: no XML: "));
  }
  const std::string whole = list("<vertex x=\"1\"/>\n<vertex x=\"2\"/>\n");
  for (std::size_t size = 0; size < whole.find("</model"); ++size) {
    CAPTURE(size);
    const std::string cut = whole.substr(0, size);
    CHECK(read(cut, 5, true).error.find("ends early") != std::string::npos);
  }
}
