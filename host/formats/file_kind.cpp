#include "host/formats/file_kind.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "host/formats/number_text.h"   // parse_real
#include "host/formats/stl_kinds.h"     // text_kind
#include "host/formats/text_scanner.h"  // is_blank

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

// Enough for most kinds, so that a pipe's first bytes are not waited for, and to tell a binary STL
// by its first facet, whatever its head says; enough for nearly all; and as much as can be seen at
// once, for text that is comments so far.
constexpr std::array<std::size_t, 3> kLookBytes{134, 4'096, InputFile::kWindowMax};
constexpr std::size_t kRefusalBytes = 4'096;

// Behind a byte order mark, blanks, and what both SIF and OBJ take as comments.
std::string_view significant(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  while (!text.empty()) {
    if (is_blank(static_cast<unsigned char>(text.front()))) {
      text.remove_prefix(1);
    } else if (text.starts_with('#')) {
      text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
    } else if (text.starts_with("(*")) {
      int open = 0;
      do {
        const bool opens = text.starts_with("(*"), closes = text.starts_with("*)");
        open += opens ? 1 : closes ? -1 : 0;
        text.remove_prefix(opens || closes ? 2 : 1);
      } while (open > 0 && !text.empty());
    } else {
      break;
    }
  }
  return text;
}

bool contains(std::string_view text, std::string_view wanted) {
  return text.find(wanted) != std::string_view::npos;
}

// "(SIF_SFF", blanks allowed behind the parenthesis.
bool begins_form(std::string_view text, std::string_view keyword) {
  if (!text.starts_with('(')) return false;
  return significant(text.substr(1)).starts_with(keyword);
}

std::string_view first_word(std::string_view line) {
  return line.substr(0, std::min(line.find_first_of(" \t"), line.size()));
}

// "v 0 0 0.5": no other format that is text has such lines.
bool is_vertex_line(std::string_view line) {
  if (first_word(line) != "v") return false;
  int numbers = 0;
  line.remove_prefix(1);
  while (numbers < 3) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string_view word = first_word(line);
    if (!parse_real(word)) return false;
    line.remove_prefix(word.size());
    ++numbers;
  }
  return true;
}

// Words that OBJ files begin with, behind their comments.
bool begins_obj(std::string_view text) {
  const std::size_t end = text.find_first_of(" \t");
  const std::string_view word = text.substr(0, end);
  for (const char* known : {"v", "vt", "vn", "vp", "f", "fo", "o", "g", "s", "mtllib", "usemtl"}) {
    if (end != std::string_view::npos && word == known) return true;
  }
  return false;
}

// Some whole line has a vertex: the words of the lines before it are unknown, and no matter.
bool has_vertex_line(std::string_view text) {
  for (std::size_t end = text.find_first_of("\r\n"); end != std::string_view::npos;
       end = text.find_first_of("\r\n")) {
    if (is_vertex_line(text.substr(0, end))) return true;
    text.remove_prefix(end + 1);
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  }
  return false;
}

bool is_text(std::string_view bytes) { return !contains(bytes, std::string_view("\0", 1)); }

// Nothing where these bytes do not tell.
std::optional<FileKind> kind_of_bytes(std::string_view bytes) {
  const std::string_view text = significant(bytes);
  if (bytes.starts_with("PK\x03\x04")) return FileKind::kZip;
  if (contains(bytes, "$$HEADERSTART")) return FileKind::kCli;
  if (contains(bytes, "-SLCVER")) return FileKind::kSlc;
  // A binary STL's 80 bytes may hold anything, what follows is no text.
  if (!is_text(bytes)) return std::nullopt;
  if (text.starts_with("Slice V0")) return FileKind::kSliceV0;
  if (begins_form(text, "LSIF")) return FileKind::kLsif;
  if (begins_form(text, "SIF_SFF")) return FileKind::kSif;
  if (text.starts_with('<')) {
    if (contains(text, "<svg")) return FileKind::kSvg;
    if (contains(text, "<amf")) return FileKind::kAmf;
  }
  if (begins_obj(text)) return FileKind::kObj;
  if (text_kind(bytes) == StlText::kOther && has_vertex_line(text)) return FileKind::kObj;
  return std::nullopt;
}

// Kinds that are known by their first words, and refused.
std::string refusal(std::string_view bytes) {
  const std::string_view text = significant(bytes);
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    return "byte 0: text in UTF-16; save it as UTF-8 or ASCII";
  }
  for (const char* keyword : {"ASCII", "MODELER"}) {
    const std::string_view word(keyword);
    if (is_text(bytes) && text.starts_with(word) &&
        (text.size() == word.size() || is_blank(static_cast<unsigned char>(text[word.size()])))) {
      return "line 1: '" + std::string(word) +
             "' begins a QuickSlice 6 .ssl file, of which no description is public, so it can't "
             "be read; export Slice V0, CLI or STL";
    }
  }
  if (bytes.starts_with("EOS 1993 SLI FILE")) {
    return "byte 0: an EOS SLI file, which can't be read; export CLI or STL";
  }
  if (bytes.starts_with("\x1F\x8B")) return "byte 0: gzip; unpack it first: gzip -dc FILE | rind …";
  return {};
}

// Text without a word of any format so far, which more of it might have.
bool may_go_on(std::string_view bytes) {
  return is_text(bytes) && text_kind(bytes) == StlText::kOther &&
         !significant(bytes).starts_with('<');
}

}  // namespace

Result<FileKind> kind_of(InputFile& file) {
  std::string_view bytes;
  for (const std::size_t count : kLookBytes) {
    if (count == kLookBytes.back() && !may_go_on(bytes)) break;
    const Result<std::string_view> window = file.window(count);
    if (!window.ok()) return window.error();
    bytes = window.value().substr(0, count);
    if (const std::optional<FileKind> kind = kind_of_bytes(bytes)) return *kind;
  }
  if (bytes.empty()) {
    return Error{ErrorCode::kBadPart, file.name() + ": the file is empty; export the part again"};
  }
  if (const std::string cause = refusal(bytes.substr(0, kRefusalBytes)); !cause.empty()) {
    return Error{ErrorCode::kBadPart, file.name() + ": " + cause};
  }
  // Comments to the end of what can be seen: only OBJ has such.
  if (bytes.size() == kLookBytes.back() && is_text(bytes) && significant(bytes).empty()) {
    return FileKind::kObj;
  }
  // Binary files of no other kind are STL, whose header may be anything.
  return FileKind::kStl;
}

}  // namespace host
