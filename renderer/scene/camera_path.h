// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/scene/camera.h"

#include <span>

namespace romascope {

/// The camera of a flight through the given ones in turn, the same time from each to the next. The
/// eye follows a uniform Catmull-Rom spline, whose ends are doubled: it passes each eye without a
/// kink, and rests from an eye to the same one. The view turns the shortest way (spherical
/// interpolation), the field of view changes evenly. `way`: 0 at the first to 1 at the last camera,
/// clamped to that; one camera stands still. The name is that of the camera it left last. There
/// must be at least one.
Camera camera_along(std::span<const Camera> stops, double way);

} // namespace romascope
