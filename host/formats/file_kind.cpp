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

// Window sizes, tried in order: enough for most kinds and for a binary STL's first facet, without
// waiting long for a pipe; enough for nearly all kinds; the largest window, for text that is only
// comments so far.
constexpr std::array<std::size_t, 3> kLookBytes{134, 4'096, InputFile::kWindowMax};
constexpr std::size_t kRefusalBytes = 4'096;

// Skips a byte order mark, blanks, and what are comments in both SIF and OBJ.
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

// "(SIF_SFF"; blanks may follow the parenthesis.
bool starts_form(std::string_view text, std::string_view keyword) {
  if (!text.starts_with('(')) return false;
  return significant(text.substr(1)).starts_with(keyword);
}

std::string_view first_word(std::string_view line) {
  return line.substr(0, std::min(line.find_first_of(" \t"), line.size()));
}

// "v 0 0 0.5": no other text format has such lines.
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

// First words of OBJ files, after their comments.
bool starts_obj(std::string_view text) {
  const std::size_t end = text.find_first_of(" \t");
  const std::string_view word = text.substr(0, end);
  for (const char* known : {"v", "vt", "vn", "vp", "f", "fo", "o", "g", "s", "mtllib", "usemtl"}) {
    if (end != std::string_view::npos && word == known) return true;
  }
  return false;
}

// True if some complete line is a vertex; unknown words in the lines before it don't matter.
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

// Nullopt if these bytes are not enough.
std::optional<FileKind> kind_of_bytes(std::string_view bytes) {
  const std::string_view text = significant(bytes);
  if (bytes.starts_with("PK\x03\x04")) return FileKind::kZip;
  if (contains(bytes, "$$HEADERSTART")) return FileKind::kCli;
  if (contains(bytes, "-SLCVER")) return FileKind::kSlc;
  // A binary STL's first 80 bytes may hold anything; the bytes after them are no text.
  if (!is_text(bytes)) return std::nullopt;
  if (text.starts_with("Slice V0")) return FileKind::kSliceV0;
  if (starts_form(text, "LSIF")) return FileKind::kLsif;
  if (starts_form(text, "SIF_SFF")) return FileKind::kSif;
  if (text.starts_with('<')) {
    if (contains(text, "<svg")) return FileKind::kSvg;
    if (contains(text, "<amf")) return FileKind::kAmf;
  }
  if (starts_obj(text)) return FileKind::kObj;
  if (text_kind(bytes) == StlText::kOther && has_vertex_line(text)) return FileKind::kObj;
  return std::nullopt;
}

// Kinds that are recognised by their first words and refused.
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

// True for text without a word of any format so far: more of it is needed.
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
  // Only comments in the largest window: only OBJ has such.
  if (bytes.size() == kLookBytes.back() && is_text(bytes) && significant(bytes).empty()) {
    return FileKind::kObj;
  }
  // A binary file of no other kind is STL, whose header may be anything.
  return FileKind::kStl;
}

}  // namespace host
