// What tests of the readers share.
#pragma once

#include "support/contains.h"
#include "support/volume_bytes.h"
#include "volsurf/core/error.h"
#include "volsurf/io/read_volume.h"

#include <gtest/gtest.h>
#include <string>

namespace volsurf::test {

/// Reads what must be refused: one line that names the file or folder first, and nothing printed. Empty where it was
/// read after all.
inline std::string refusal(const std::filesystem::path &path, const ReadOptions &options = {})
{
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  std::string message;
  try {
    read_volume(path, options);
  } catch (const InputError &error) {
    message = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_EQ(message.rfind(path.string(), 0), 0U) << message;
  return message;
}

} // namespace volsurf::test
