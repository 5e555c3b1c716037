#include "host/formats/threemf_package.h"

#include <utility>

namespace host {

using core::Result;

std::string without_slash(const std::string& path) {
  return path.starts_with('/') ? path.substr(1) : path;
}

Result<XmlScanner> scanner_of(const ZipArchive& archive, const std::string& part) {
  Result<XmlScanner::ByteSource> bytes = archive.bytes_of(part);
  if (!bytes.ok()) return bytes.error();
  return XmlScanner(archive.name() + " (" + part + ")", std::move(bytes).value(), false);
}

Result<std::string> root_model(const ZipArchive& archive) {
  if (archive.contains("_rels/.rels")) {
    Result<XmlScanner> xml = scanner_of(archive, "_rels/.rels");
    if (!xml.ok()) return xml.error();
    while (true) {
      const Result<const XmlEvent*> event = xml.value().next();
      if (!event.ok()) return event.error();
      if (event.value() == nullptr) break;
      const std::string* type = event.value()->attribute("Type");
      const std::string* target = event.value()->attribute("Target");
      if (event.value()->name == "Relationship" && type && target && type->ends_with("3dmodel")) {
        return without_slash(*target);
      }
    }
  }
  std::string usual = archive.find_ending(".model");
  if (usual.empty()) {
    return core::Error{core::ErrorCode::kBadPart,
                       archive.name() + ": a zip archive without a 3MF model; export 3MF or STL"};
  }
  return usual;
}

}  // namespace host
