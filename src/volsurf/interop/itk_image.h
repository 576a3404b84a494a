// Volume to itk::Image, and filters of ITK run as stages of ours: on our threads, with our progress, silently.
// For sources only, since it includes ITK.
#pragma once

#include "volsurf/core/progress.h"
#include "volsurf/core/volume.h"

#include <itkImage.h>

namespace volsurf {

using ItkVolume = itk::Image<float, 3>;

/// The volume's samples and spacing, not copied: `volume` must outlive the image, which nobody may write to. Origin and
/// direction are left out: they do not matter to filters.
ItkVolume::Pointer borrow_volume(const Volume &volume);

/// Updates a filter, with as many work units as there are threads. Throws Cancelled where `progress` asks for it, which
/// only filters notice that look at AbortGenerateData, and Error where ITK fails.
void run_itk_filter(itk::ProcessObject &filter, std::string_view stage, const Progress &progress);

} // namespace volsurf
