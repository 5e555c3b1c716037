// Checks the target of an output before anything is written.
//
//     new        no file has that name: it is made
//     regular    it is replaced when the new file is complete; mode, owner and links to it stay
//     stream     a pipe, /dev/null, the program's own terminal: written straight away
//     otherwise  refused: folders, sockets, block devices, devices that may move something
//
// A symbolic link at the end of the path is followed. A link of another user in a folder where all
// may write (/tmp) is refused, as Linux does (protected_symlinks).
#pragma once

#include <sys/stat.h>

#include <optional>
#include <string>

#include "core/result.h"  // Result

namespace host {

// Identifies a file, whatever name leads to it.
struct FileIdentity {
  dev_t device = 0;
  ino_t number = 0;
  bool operator==(const FileIdentity&) const = default;
};

// Of the file that a path leads to (links are followed), or of an open file. nullopt if none.
[[nodiscard]] std::optional<FileIdentity> identity_of(const std::string& path);
[[nodiscard]] std::optional<FileIdentity> identity_of(int descriptor);

struct OutputTarget {
  enum class Kind { kNew, kRegular, kStream };
  Kind kind = Kind::kNew;
  std::string path;  // of the file itself, behind links
  std::string folder;
  std::string name;  // within the folder
  FileIdentity folder_identity;
  FileIdentity file;             // the existing file
  mode_t mode = 0666;            // of the existing file
  bool standard_output = false;  // the path is another name of standard output
};

// Errors name the path, the cause and what to do.
[[nodiscard]] core::Result<OutputTarget> look_at_target(const std::string& path);

}  // namespace host
