// Names of temporary files, kept where a signal handler can read them: it deletes the files if it
// ends the program.
#pragma once

#include <string>

namespace host {

// Remembers one name while the object exists. A name is not remembered if it is too long or if
// kUnfinishedFilesMax are remembered already.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const std::string& path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

 private:
  int slot_ = -1;
};

// Deletes all remembered files. Safe in a signal handler.
void remove_unfinished_files();

}  // namespace host
