// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/program.h"
#include "renderer/passes/frame_context.h"
#include "renderer/tracers/candidate_set.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace romascope {

/// How rays leave the surface they start on.
struct Leaving {
    double offset = 0.0; ///< how far they start off it, along its normal, metres
    int escape = 0;      ///< occupied cells that they may pass at their very start
};

/// A visibility structure: built from the scene each frame, asked by any estimator.
///
/// Its GLSL file, which estimators include as "tracer.glsl", gives
///     bool  tracer_any_hit(vec3 point, vec3 normal, vec3 direction, float t_max)
///     float tracer_closest_hit(vec3 point, vec3 normal, vec3 direction, float t_max)
/// for a ray from a surface point with unit normal and direction; t_max in metres from the surface,
/// infinity allowed; the distance in metres, negative for a miss. How far the ray's start is moved
/// off the surface is the tracer's own affair. One with a fixed set of directions can also give the
/// functions over those (see roma_tracer.glsl) and say so with sample_candidates().
class Tracer {
public:
    virtual ~Tracer() = default;

    /// Builds the structure for this frame. Throws Error if it cannot be held.
    virtual void build(const FrameContext& frame) = 0;

    /// The GLSL file below shaders/, and the defines it needs under these settings.
    virtual std::string shader_file() const = 0;
    virtual std::vector<ShaderDefine> shader_defines(const Settings& settings) const = 0;
    /// True if estimators shall choose among the tracer's candidates under these settings.
    virtual bool sample_candidates(const Settings&) const { return false; }

    // Of the last build, for those who ask what the answers are made of.
    virtual Leaving leaving() const = 0;
    /// Empty if rays keep their own direction.
    virtual CandidateSet candidate_set() const { return {}; }

    /// Binds what was built for the GLSL file: texture units, storage and uniform blocks from 4 up.
    /// `program`, in use, includes the GLSL file: for uniforms.
    virtual void bind(const Program& program) const = 0;

    virtual std::vector<StructureBytes> bytes() const = 0;
    /// What `bytes()` can come to at most under these settings, whatever the scene; known before
    /// anything is built.
    virtual size_t bytes_needed(const Settings& settings) const = 0;
    /// What tracing counted since the last build, such as rays that it gave up. Waits for the GPU.
    virtual std::vector<NamedCount> counts() const { return {}; }
    /// All programs of the build and of the views under these settings, for tests that compile
    /// them.
    virtual std::vector<ShaderVariant> build_variants(const Settings& settings) const = 0;

    /// Views of what was built, for people, by their names in lower-case words; a setting picks one
    /// (structure_view.h).
    virtual std::vector<std::string_view> views() const { return {}; }
    /// Draws one of `views()` into `picture`, RGBA32F, linear, row 0 at the top, of any size.
    virtual void draw_view(const FrameContext&, std::string_view, const Texture&) {}
};

/// What `romascope info` and the settings know of a tracer before there is one.
struct TracerEntry {
    std::string_view name;
    std::string_view description;
    std::unique_ptr<Tracer> (*make)();
    std::vector<const KnobBase*> (*knobs)(); ///< its own, without those of what it shares
};

/// All tracers. A new one is a folder here, a GLSL file, and a line in registry.cpp.
const std::vector<TracerEntry>& tracers();

/// Whether the knob belongs to tracers alone, none of which is the one of this name.
bool is_of_other_tracer(const KnobBase& knob, std::string_view tracer);

/// The knobs of all tracers and of what they share: all that decides which rays hit. Views of
/// structures have their own, see structure_view.h.
std::vector<const KnobBase*> tracer_knobs();

} // namespace romascope
