// A file that is written as the print is computed, and that is there only when it is whole.
//
//     open ──> a file without a name ──write …──> commit ──> OUT.gcode
//                  └── destroyed without commit, or the program ends: gone, nothing is left
//
// Where the file system knows no files without a name, it has a random one in OUT's folder
// (.rind-0123456789abcdef), made anew and through no link, which goes with it; only a power cut or
// SIGKILL leaves that one behind. What a name may stand for is output_target.h's: of an older file
// mode, owner and symbolic links to it stay; other hard links to it keep the older content.
//
// A stream (a pipe, /dev/null, standard output) is written straight away: it has no name to hold
// back. One program writes a name at a time (name_lock.h).
#pragma once

#include <cstddef>
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
  // How what is not whole yet is kept; kNamed is what kNameless falls back to.
  enum class Unfinished { kNameless, kNamed };

  // "-" is standard output. An error names the path and the cause. Waits for a pipe's reader.
  [[nodiscard]] static core::Result<OutputFile> open(const std::string& path,
                                                     Unfinished unfinished = Unfinished::kNameless);

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;
  ~OutputFile();

  // Buffered up to kFileBufferBytes. An error, such as a full disk, is final.
  [[nodiscard]] core::Status write(std::string_view text);

  // Writes what is left and gives the file its name; an error where somebody else has made a file
  // of that name meanwhile, and with kNothing after a stop signal. REQUIRES: no write failed.
  enum class AfterStop { kNothing, kWrite };
  [[nodiscard]] core::Status commit(AfterStop after_stop = AfterStop::kNothing);

 private:
  OutputFile(int descriptor, std::string path);
  [[nodiscard]] core::Status begin(Unfinished unfinished);
  [[nodiscard]] bool begin_nameless();
  [[nodiscard]] bool begin_named();
  [[nodiscard]] bool give_name();
  [[nodiscard]] core::Status flush();

  int descriptor_;
  std::string path_;  // as people typed it
  OutputTarget target_;
  NameLock lock_;
  std::string temporary_;  // its name until it is whole; empty: none
  std::unique_ptr<UnfinishedFile> unfinished_;
  std::string buffer_;
};

// All of it to standard output, or why that failed.
[[nodiscard]] core::Status write_standard_output(std::string_view text);

}  // namespace host
