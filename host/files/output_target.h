// What stands where an output is to be written, looked at before anything is written.
//
//     new        no file of that name: it is made
//     regular    it is replaced when the new one is whole; mode, owner and links to it stay
//     stream     a pipe, /dev/null, the program's own terminal: written as it comes
//     otherwise  refused: folders, sockets, block devices, devices that may move something
//
// Symbolic links that end the name are followed, to the file that they stand for. One that somebody
// else has put into a folder where all may write (/tmp) is refused, as the system itself does.
#pragma once

#include <sys/stat.h>

#include <optional>
#include <string>

#include "core/result.h"  // Result

namespace host {

// The same for all names of one file.
struct FileIdentity {
  dev_t device = 0;
  ino_t number = 0;
  bool operator==(const FileIdentity&) const = default;
};

// Of what a name stands for, links followed, or of an open file; nothing: there is none.
[[nodiscard]] std::optional<FileIdentity> identity_of(const std::string& path);
[[nodiscard]] std::optional<FileIdentity> identity_of(int descriptor);

struct OutputTarget {
  enum class Kind { kNew, kRegular, kStream };
  Kind kind = Kind::kNew;
  std::string path;  // of the file itself, behind links
  std::string folder;
  std::string name;              // in it
  FileIdentity folder_place;     // where a new one will be, however the folder is named
  FileIdentity file;             // of what is there
  mode_t mode = 0666;            // of what is there
  bool standard_output = false;  // another name of it
};

// Errors name the path, the cause and what to do.
[[nodiscard]] core::Result<OutputTarget> look_at_target(const std::string& path);

}  // namespace host
