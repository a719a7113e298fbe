// SPDX-License-Identifier: MIT
#include "renderer/tracers/dda/dda_tracer.h"

namespace romascope {

std::vector<const KnobBase*> dda_knobs() { return {&kDdaNormalOffset, &kDdaEscape}; }

std::unique_ptr<Tracer> make_dda_tracer() { return std::make_unique<DdaTracer>(); }

} // namespace romascope
