// The world frame that an output file uses.
#pragma once

#include "volsurf/core/mesh.h"

#include <string>

namespace volsurf {

/// Both are millimetres. lps: x to the patient's left, y to the back, z to the head, as in ITK and DICOM; what every
/// stage uses. ras: x to the right, y to the front, as in NIfTI. They differ by a half turn about z, so windings stay.
enum class Frame { lps, ras };

/// The name that 3D Slicer looks for in a file: "LPS" or "RAS".
inline std::string frame_name(Frame frame)
{
  return frame == Frame::ras ? "RAS" : "LPS";
}

/// The same place, given in LPS, in `frame`. Subtracting from 0 avoids -0, which shows in text files.
inline Point to_frame(const Point &lps, Frame frame)
{
  return frame == Frame::ras ? Point{0 - lps[0], 0 - lps[1], lps[2]} : lps;
}

} // namespace volsurf
