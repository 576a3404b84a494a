// The report of a run, parsed.
#pragma once

#include "support/program.h"

#include <nlohmann/json.hpp>

namespace volsurf::test {

inline nlohmann::json report_of(const Outcome &outcome)
{
  return nlohmann::json::parse(outcome.out, nullptr, false); // "discarded", which equals nothing, where it is no JSON
}

} // namespace volsurf::test
