// An output file that gets its name only when it is complete.
//
//     open ──> a file without a name ──write …──> commit ──> OUT.gcode
//                  └── destroyed without commit, or the program ends: gone, nothing is left
//
// If the file system has no files without a name, the file gets a random name in OUT's folder
// (.rind-0123456789abcdef). It is a new file, never one behind a link, and it is deleted too; only
// a power cut or SIGKILL leaves it behind. output_target.h says which targets are allowed. A
// replaced file keeps its mode, its owner and the symbolic links to it; other hard links keep the
// old content.
//
// A stream (a pipe, /dev/null, standard output) is written straight away. Only one program writes a
// name at a time (name_lock.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/result.h"                   // Result, Status
#include "host/files/name_lock.h"          // NameLock
#include "host/files/output_target.h"      // OutputTarget
#include "host/system/unfinished_files.h"  // UnfinishedFile

namespace host {

class OutputFile {
 public:
  // How the incomplete file is kept. kNameless falls back to kNamed.
  enum class Unfinished { kNameless, kNamed };

  // "-" is standard output. Errors name the path and the cause. Waits for a pipe's reader.
  [[nodiscard]] static core::Result<OutputFile> open(const std::string& path,
                                                     Unfinished unfinished = Unfinished::kNameless);

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  // Buffered up to kFileBufferBytes. An error, such as a full disk, is final.
  [[nodiscard]] core::Status write(std::string_view text);

  // Whether what was written can be patched: not in a stream.
  [[nodiscard]] bool patchable() const { return target_.kind != OutputTarget::Kind::kStream; }
  // Bytes written so far.
  [[nodiscard]] std::int64_t position() const { return position_; }
  // Writes over what is there. REQUIRES: patchable(), offset + text's size <= position().
  [[nodiscard]] core::Status patch(std::int64_t offset, std::string_view text);

  // Writes the rest and gives the file its name. Errors: somebody else has made a file of that name
  // meanwhile; a stop signal has come (with kNothing). REQUIRES: no write failed.
  enum class AfterStop { kNothing, kWrite };
  [[nodiscard]] core::Status commit(AfterStop after_stop = AfterStop::kNothing);

 private:
  OutputFile(int descriptor, std::string path);
  [[nodiscard]] core::Status start(Unfinished unfinished);
  [[nodiscard]] bool start_nameless();
  [[nodiscard]] bool start_named();
  [[nodiscard]] bool give_name();
  [[nodiscard]] core::Status flush();

  int descriptor_;
  std::string path_;  // as people typed it
  OutputTarget target_;
  NameLock lock_;
  std::string temporary_;  // its name until it is complete; empty: none
  std::unique_ptr<UnfinishedFile> unfinished_;
  std::string buffer_;
  std::int64_t position_ = 0;
};

// Writes all of the text to standard output.
[[nodiscard]] core::Status write_standard_output(std::string_view text);

}  // namespace host
