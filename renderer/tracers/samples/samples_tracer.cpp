// SPDX-License-Identifier: MIT
#include "renderer/tracers/samples/samples_tracer.h"

namespace romascope {

std::vector<const KnobBase*> samples_knobs() {
    return {&kSamplesCount, &kSamplesNormalOffset, &kSamplesEscape};
}

std::unique_ptr<Tracer> make_samples_tracer() { return std::make_unique<SamplesTracer>(); }

} // namespace romascope
