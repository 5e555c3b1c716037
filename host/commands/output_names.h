// Whether what a command is to write may be written where it says: looked at before anything is
// opened, so that nothing of the user's is lost to a slip of the hand.
//
//     --output, --stats, --log, --journal      may be new, or a file that holds the like
//       never   the part, the profile, the journal that is resumed, by whatever name
//       never   two of them, or one of them and standard output, in one file
//       never   a part of another kind, an archive, a picture, a text that is another thing: what
//               is there has to be of the output's kind, or a text whose name ends like the kind's
#pragma once

#include "core/result.h"            // Status
#include "host/settings/options.h"  // Options

namespace host {

// Errors name the option, the file, the cause and what to do.
[[nodiscard]] core::Status check_output_names(const Options& options);

// Whether the output goes where standard output goes, under whichever name.
[[nodiscard]] bool result_on_standard_output(const Options& options);

}  // namespace host
