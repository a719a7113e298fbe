// SPDX-License-Identifier: MIT
#pragma once

#include "app/viewer/interface/knob_editor.h"

namespace romascope {

class Session;

/// What a text knob can name in this session: tracers, views of the structure, cameras and
/// animations of the scene. Empty for other knobs.
KnownNames known_names(const KnobBase& knob, const Session& session);

} // namespace romascope
