#include "host/commands/output_names.h"

#include <unistd.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/files/input_file.h"
#include "host/files/log_file.h"  // older_logs
#include "host/files/output_target.h"
#include "host/formats/formats.h"        // kind_of
#include "host/output/png_writer.h"      // kPictureWords
#include "host/printing/journal_file.h"  // look_at_journal
#include "host/system/limits.h"          // kLookBytesMax

namespace host {
namespace {

using core::Error;
using core::ErrorCode;
using core::Result;
using core::Status;

struct Named {
  std::string what;  // "the part", "--stats"
  std::string path;
};

Error refused(const std::string& path, const std::string& cause) {
  return {ErrorCode::kUnreadable, path + ": " + cause};
}

std::vector<Named> inputs_of(const Options& options) {
  std::vector<Named> inputs;
  if (!options.part.path.empty()) inputs.push_back({"the part", options.part.path});
  for (const std::string& path : options.part.more_paths) inputs.push_back({"a part", path});
  if (!options.settings.profile.empty())
    inputs.push_back({"the profile", options.settings.profile});
  if (options.subcommand == Subcommand::kResume && !options.print.journal.empty()) {
    inputs.push_back({"the journal", options.print.journal});
  }
  return inputs;
}

std::vector<Named> outputs_of(const Options& options) {
  std::vector<Named> outputs;
  if (!options.output.path.empty()) outputs.push_back({"--output", options.output.path});
  if (!options.stats.empty()) outputs.push_back({"--stats", options.stats});
  if (!options.log.empty()) outputs.push_back({"--log", options.log});
  if (options.subcommand == Subcommand::kPrint && !options.print.journal.empty()) {
    outputs.push_back({"--journal", options.print.journal});
  }
  return outputs;
}

std::optional<FileIdentity> input_identity(const Named& input) {
  return input.path == "-" ? identity_of(STDIN_FILENO) : identity_of(input.path);
}

// An output to a file.
struct Claim {
  std::string what;
  OutputTarget target;
};

bool same_file(const OutputTarget& a, const OutputTarget& b) {
  using Kind = OutputTarget::Kind;
  if (a.kind == Kind::kStream || b.kind == Kind::kStream) return false;
  if (a.kind == Kind::kRegular && b.kind == Kind::kRegular && a.file == b.file) return true;
  return a.folder_identity == b.folder_identity && a.name == b.name;
}

// The shell may have redirected standard output to a file.
Status check_standard_output(const std::vector<Named>& inputs, const std::vector<Claim>& claims) {
  struct stat status {};
  if (::fstat(STDOUT_FILENO, &status) != 0 || !S_ISREG(status.st_mode)) return {};
  const std::optional<FileIdentity> out = identity_of(STDOUT_FILENO);
  for (const Named& input : inputs) {
    if (input_identity(input) != out) continue;
    return refused(input.path,
                   "standard output goes to " + input.what + " itself; send it elsewhere");
  }
  for (const Claim& claim : claims) {
    if (claim.target.kind != OutputTarget::Kind::kRegular || claim.target.file != out) continue;
    return refused(claim.target.path,
                   "standard output and " + claim.what + " go to the same file; name another one");
  }
  return {};
}

bool is_png(const Options& options) {
  return options.subcommand == Subcommand::kShow &&
         picture_format_of(options.output.path) == PictureFormat::kPng;
}

// Whether `rind show` has made it, by the words near its start.
bool is_own_png(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 128);
  return head.starts_with("\x89PNG\r\n\x1A\n") && head.find(kPictureWords) != head.npos;
}

// The kind of file that this output may replace; nullopt: only text, or a PNG.
std::optional<FileKind> own_kind(const Options& options, const std::string& what) {
  if (what != "--output") return std::nullopt;
  if (is_png(options)) return std::nullopt;
  if (options.subcommand == Subcommand::kShow) return FileKind::kSvg;
  switch (options.output.format) {
    case OutputFormat::kGcode:
      return std::nullopt;
    case OutputFormat::kCli:
    case OutputFormat::kCliBinary:
    case OutputFormat::kCliRoads:
      return FileKind::kCli;
    case OutputFormat::kLsif:
      return FileKind::kLsif;
    case OutputFormat::kSliceV0:
      return FileKind::kSliceV0;
    case OutputFormat::kSvg:
      return FileKind::kSvg;
  }
  return std::nullopt;
}

// Unknown text counts as ASCII STL; true if the text has the words of STL.
bool starts_like_stl(std::string bytes) {
  for (char& c : bytes) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  return begin != std::string::npos && bytes.compare(begin, 5, "solid") == 0 &&
         bytes.find("facet") != std::string::npos;
}

// True if the name has this output's ending.
bool named_so(const Options& options, const Claim& claim) {
  if (claim.what == "--stats") return claim.target.name.ends_with(".json");
  if (claim.what != "--output") return false;
  const std::optional<OutputFormat> named = output_format_of(claim.target.name, "");
  if (options.subcommand == Subcommand::kShow)
    return !is_png(options) && named == OutputFormat::kSvg;
  const bool cli = own_kind(options, claim.what) == FileKind::kCli;
  return named == options.output.format || (cli && named == OutputFormat::kCli);
}

// True if text that is no part looks like this output: G-code's first word or comment, JSON, a
// log's first time.
bool is_alike(const Options& options, const std::string& text, const std::string& what) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return true;
  const char first = text[begin], second = begin + 1 < text.size() ? text[begin + 1] : '\0';
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  if (what == "--stats") return first == '{' || first == '[';
  if (what == "--log") return digit(first);
  if (options.subcommand == Subcommand::kShow || options.output.format != OutputFormat::kGcode)
    return false;
  const bool word = std::string_view("GMTNgmtn").find(first) != std::string_view::npos;
  return first == ';' || first == '%' || (word && digit(second));
}

bool is_journal(const std::string& path) {
  const JournalStanding standing = look_at_journal(path).standing;
  return standing != JournalStanding::kAbsent && standing != JournalStanding::kForeign;
}

Status check_content(const Options& options, const Claim& claim) {
  if (is_journal(claim.target.path)) {
    return refused(claim.target.path, "this is the journal of a print, which " + claim.what +
                                          " does not replace; name another file");
  }
  Result<InputFile> opened = InputFile::open(claim.target.path);
  if (!opened.ok()) {
    return refused(claim.target.path, "there is a file that can't be read, so " + claim.what +
                                          " does not replace it; name another one");
  }
  const Result<std::string_view> looked = opened.value().window(kLookBytesMax);
  if (!looked.ok()) return looked.error();
  const std::string bytes(looked.value().substr(0, kLookBytesMax));
  if (bytes.empty()) return {};
  if (claim.what == "--output" && is_png(options) && is_own_png(bytes)) return {};
  const Result<FileKind> kind = kind_of(opened.value());
  if (kind.ok() && kind.value() == own_kind(options, claim.what)) return {};
  const bool text = bytes.find('\0') == std::string::npos;
  const bool plain = text && kind.ok() && kind.value() == FileKind::kStl && !starts_like_stl(bytes);
  if (plain && (named_so(options, claim) || is_alike(options, bytes, claim.what))) return {};
  return refused(claim.target.path,
                 "this file is no earlier output of " + claim.what +
                     ", so it is not replaced; name another file, or delete this one first");
}

Status check_against_inputs(const Claim& claim, const std::vector<Named>& inputs) {
  if (claim.target.kind == OutputTarget::Kind::kNew) return {};
  for (const Named& input : inputs) {
    const bool same = input_identity(input) == claim.target.file;
    // The terminal and /dev/null may be named twice.
    if (!same ||
        (claim.target.kind == OutputTarget::Kind::kStream && !claim.target.standard_output)) {
      continue;
    }
    return refused(claim.target.path, claim.what + " names " + input.what +
                                          " itself, which would be lost; name another file");
  }
  return {};
}

Status check_against_others(const Claim& claim, const std::vector<Claim>& others) {
  for (const Claim& other : others) {
    if (!same_file(claim.target, other.target)) continue;
    return refused(claim.target.path,
                   claim.what + " and " + other.what + " name the same file; name two");
  }
  return {};
}

}  // namespace

Status check_output_names(const Options& options) {
  const std::vector<Named> inputs = inputs_of(options);
  std::vector<Claim> claims;
  for (const Named& output : outputs_of(options)) {
    if (output.path == "-") continue;
    // A journal is opened with rules of its own (printing/journal.h).
    const bool journal = output.what == "--journal";
    Result<OutputTarget> target = look_at_target(output.path);
    if (!target.ok() && journal) continue;
    if (!target.ok()) return target.error();
    const Claim claim{output.what, std::move(target).value()};
    if (Status apart = check_against_inputs(claim, inputs); !apart.ok()) return apart;
    if (Status apart = check_against_others(claim, claims); !apart.ok()) return apart;
    if (!journal && claim.target.kind == OutputTarget::Kind::kRegular) {
      if (Status like = check_content(options, claim); !like.ok()) return like;
    }
    claims.push_back(claim);
    if (output.what != "--log") continue;
    for (const std::string& older : older_logs(claim.target.path)) {
      Result<OutputTarget> place = look_at_target(older);
      if (!place.ok()) return place.error();
      const Claim kept{"the older part of --log", std::move(place).value()};
      if (Status apart = check_against_inputs(kept, inputs); !apart.ok()) return apart;
      if (Status apart = check_against_others(kept, claims); !apart.ok()) return apart;
      claims.push_back(kept);
    }
  }
  return check_standard_output(inputs, claims);
}

bool result_on_standard_output(const Options& options) {
  if (options.output.path.empty()) return false;
  return options.output.path == "-" ||
         identity_of(options.output.path) == identity_of(STDOUT_FILENO);
}

}  // namespace host
