// A comparison as text for people and as JSON.
#pragma once

#include "volsurf/pipeline/compare_files.h"

#include <string>

namespace volsurf {

/// A table. Widths are in characters; each line ends with a line break.
std::string to_table(const ComparedFiles &files);

/// JSON as docs/comparison.schema.json describes it. Values without a meaning, and infinity, are null.
std::string to_json(const ComparedFiles &files);

/// "assd<=0.3 is not met: it is 0.41".
std::string failure_text(const Requirement &requirement, const Comparison &comparison);

} // namespace volsurf
