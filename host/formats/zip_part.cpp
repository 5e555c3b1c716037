#include "host/formats/zip_part.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/formats/file_kind.h"     // kind_of
#include "host/formats/stl_kinds.h"     // is_binary_stl, text_kind
#include "host/formats/text_scanner.h"  // shown

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;

constexpr std::array<std::string_view, 6> kMeshEndings{".stl", ".obj", ".amf",
                                                       ".3mf", ".sif", ".zip"};
constexpr std::array<std::string_view, 5> kLayerEndings{".cli", ".slc", ".ssl", ".lsif", ".svg"};

// Entries that an error names.
constexpr std::size_t kNamesMax = 5;
constexpr std::size_t kStlLookBytes = 4'096;

bool made_by_systems(const std::string& key) {
  const std::string name = key.substr(key.rfind('/') + 1);
  return key.starts_with("__macosx/") || name.starts_with('.') || name == "thumbs.db";
}

std::vector<std::string> with_ending(const std::vector<std::string>& entries,
                                     std::span<const std::string_view> endings) {
  std::vector<std::string> found;
  for (const std::string& entry : entries) {
    const std::string key = entry_key(entry);
    const bool fits = std::any_of(endings.begin(), endings.end(),
                                  [&](std::string_view ending) { return key.ends_with(ending); });
    if (fits) found.push_back(entry);
  }
  return found;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < kNamesMax; ++i) {
    text += (i == 0 ? "" : ", ") + shown(names[i], 60);
  }
  if (names.size() > kNamesMax) text += ", " + std::to_string(names.size() - kNamesMax) + " more";
  return text;
}

// Elsewhere, unknown bytes are read as STL; here only certain STL counts.
bool is_mesh(InputFile& file) {
  const Result<FileKind> kind = kind_of(file);
  if (!kind.ok()) return false;
  if (kind.value() != FileKind::kStl) return true;
  const Result<std::string_view> window = file.window(kStlLookBytes);
  return window.ok() &&
         (is_binary_stl(file, window.value()) || text_kind(window.value()) == StlText::kStl);
}

}  // namespace

bool is_threemf(const ZipArchive& archive) {
  return archive.contains("_rels/.rels") || !archive.find_ending(".model").empty();
}

Result<InputFile> only_part(const ZipArchive& archive) {
  const auto refused = [&archive](const std::string& cause) {
    return Error{ErrorCode::kBadPart, archive.name() + ": " + cause};
  };
  std::vector<std::string> entries = archive.entries();
  std::erase_if(entries, [](const auto& entry) { return made_by_systems(entry_key(entry)); });
  std::vector<std::string> parts = with_ending(entries, kMeshEndings);
  if (parts.empty()) parts = with_ending(entries, kLayerEndings);
  if (parts.empty() && entries.size() <= kZipLooksMax) {
    for (const std::string& entry : entries) {
      Result<InputFile> file = archive.unpacked(entry);
      if (!file.ok()) return file.error();
      if (is_mesh(file.value())) parts.push_back(entry);
    }
  }
  if (parts.empty()) {
    return refused("a zip archive without a 3MF model or another part" +
                   (entries.empty() ? "" : " (it holds " + listed(entries) + ")") +
                   "; export 3MF or STL");
  }
  if (parts.size() > 1) {
    return refused("a zip archive with " + std::to_string(parts.size()) + " parts (" +
                   listed(parts) + "); unpack it and name one of them");
  }
  return archive.unpacked(parts.front());
}

}  // namespace host
