// SPDX-License-Identifier: MIT
#include "renderer/tracers/samples/samples_tracer.h"

namespace romascope {

std::vector<const KnobBase*> samples_knobs() {
    return {&kSamplesCount, &kSamplesNormalOffset, &kSamplesEscape};
}

std::unique_ptr<Tracer> make_samples_tracer() { return std::make_unique<SamplesTracer>(); }

std::vector<ShaderDefine> SamplesTracer::shader_defines(const Settings& settings) const {
    return romascope::shader_defines(settings,
                                     {&kSamplesCount, &kSamplesNormalOffset, &kSamplesEscape});
}

} // namespace romascope
