// SPDX-License-Identifier: MIT
// The measuring of a benchmark: all variants in turn, round by round, in one process.
#pragma once

#include "app/bench/variants.h"
#include "renderer/frame/pipeline.h"
#include "renderer/passes/empty.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace romascope {

/// Times of one variant; each pass has one for each round.
struct VariantTimes {
    std::string name;
    std::vector<PassTiming> build, trace;
    size_t bytes = 0; ///< of its structure
};

struct BenchTimes {
    TimerClock clock = TimerClock::none;
    int rounds = 0;
    PassTiming empty; ///< an empty dispatch
    PassTiming gbuffer;
    std::vector<VariantTimes> variants;
};

/// Passes shorter than this are timed in batches of so many.
inline constexpr double kShortPassMs = 0.05;
inline constexpr int kBatch = 64;

class Benchmark {
public:
    /// Needs a current context. Keeps a reference to the scene, which stands as in `pose`.
    /// Throws Error if the driver has no clock.
    Benchmark(const Scene& scene, const Pose& pose, const Camera& camera,
              const std::vector<BenchVariant>& variants);
    Benchmark(const Scene&&, const Pose&, const Camera&, const std::vector<BenchVariant>&) = delete;

    /// Compiles, finds the passes that want batches, and keeps the device at work for a second.
    void warm_up();
    /// Measures. `rounds`: how many; 0: as many as fit in `seconds`, at least a few. `progress`, if
    /// there is one, is told between rounds what share is done.
    BenchTimes run(int rounds, double seconds, const std::function<void(double)>& progress = {});

private:
    struct Subject {
        std::string name;
        Settings settings;
        std::unique_ptr<Tracer> tracer;
        AmbientOcclusion ambient_occlusion;
        PassTimer build_timer, trace_timer;
    };
    void run_round();

    ShaderLibrary shaders_;
    GpuScene scene_;
    Camera camera_;
    PassTimer shared_timer_; ///< of what no variant has for itself
    EmptyPass empty_;
    GBuffer gbuffer_;
    std::vector<Subject> subjects_;
    uint32_t round_ = 0;
};

} // namespace romascope
