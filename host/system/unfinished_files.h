// Temporary names that have to go when the program ends in the middle: a signal's handler may take
// them away, so they are kept where it can read them.
#pragma once

#include <string>

namespace host {

// One name, as long as the object lives. With all places taken, or a name that is too long, it is
// not remembered.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const std::string& path);
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

 private:
  int place_ = -1;
};

// Deletes all that are remembered. Safe in a signal's handler.
void remove_unfinished_files();

}  // namespace host
