// SPDX-License-Identifier: MIT
#include "app/bench/measure.h"

#include "renderer/base/error.h"
#include "renderer/gl/debug.h"
#include "renderer/passes/deform.h"

#include <algorithm>
#include <chrono>

namespace romascope {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kFewestRounds = 5, kMostRounds = 500;
constexpr int kRoundsToFindShortPasses = 3;
constexpr double kWarmUpSeconds = 1.0;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

} // namespace

Benchmark::Benchmark(const Scene& scene, const Pose& pose, const Camera& camera,
                     const std::vector<BenchVariant>& variants)
    : scene_(scene), camera_(camera) {
    if (shared_timer_.clock() == TimerClock::none)
        throw Error("this driver has no timestamps: nothing can be timed");
    if (!scene.motion.parts.empty())
        Deform(scene.motion).run(shaders_, shared_timer_, scene_, scene.motion, pose);
    for (const BenchVariant& variant : variants) {
        Subject& subject = subjects_.emplace_back(Subject{variant.name, variant.settings});
        subject.tracer = make_tracer(variant.settings.get(kTracer));
    }
}

void Benchmark::run_round() {
    const Settings& shared = subjects_.front().settings;
    const auto seed = static_cast<uint32_t>(shared.get(kSeed));
    const View view = view_of_frame(shared, camera_, scene_.bounds(), round_);
    empty_.run(shaders_, shared_timer_);
    // Long enough that the device has work while the commands for the variants are written.
    gbuffer_.draw({shared, shaders_, scene_, shared_timer_, seed, round_}, view);
    for (size_t i = 0; i < subjects_.size(); ++i) {
        // Another one first each time, so that none is always after the same.
        Subject& subject = subjects_[(i + round_) % subjects_.size()];
        subject.tracer->build(
            {subject.settings, shaders_, scene_, subject.build_timer, seed, round_});
        subject.ambient_occlusion.run(
            {subject.settings, shaders_, scene_, subject.trace_timer, seed, round_}, view, gbuffer_,
            *subject.tracer);
    }
    ++round_;
    glFinish(); // a round is a round
    check_gl_error("a round of the benchmark");
}

void Benchmark::warm_up() {
    const auto for_all_timers = [this](const auto& act) {
        act(shared_timer_);
        for (Subject& subject : subjects_) {
            act(subject.build_timer);
            act(subject.trace_timer);
        }
    };
    run_round(); // compiles
    for_all_timers([](PassTimer& timer) { timer.clear(); });
    for (int i = 0; i < kRoundsToFindShortPasses; ++i)
        run_round();
    for_all_timers([](PassTimer& timer) { timer.clear_and_batch(kShortPassMs, kBatch); });
    const Clock::time_point begin = Clock::now();
    do {
        run_round();
    } while (seconds_since(begin) < kWarmUpSeconds);
    for_all_timers([](PassTimer& timer) { timer.clear(); });
}

BenchTimes Benchmark::run(int rounds, double seconds, const std::function<void(double)>& progress) {
    BenchTimes times;
    const Clock::time_point begin = Clock::now();
    // At 1 it is enough.
    const auto share_done = [&] {
        if (rounds > 0)
            return double(times.rounds) / rounds;
        const double by_time =
            std::min(seconds_since(begin) / seconds, double(times.rounds) / kFewestRounds);
        return std::max(by_time, double(times.rounds) / kMostRounds);
    };
    for (double share = 0.0; share < 1.0; share = share_done()) {
        run_round();
        ++times.rounds;
        if (progress)
            progress(share_done());
    }
    shared_timer_.finish();
    times.clock = shared_timer_.clock();
    times.empty = shared_timer_.timings().at(0);
    times.gbuffer = shared_timer_.timings().at(1);
    for (Subject& subject : subjects_) {
        subject.build_timer.finish();
        subject.trace_timer.finish();
        VariantTimes& of_variant = times.variants.emplace_back();
        of_variant.name = subject.name;
        of_variant.build = subject.build_timer.timings();
        of_variant.trace = subject.trace_timer.timings();
        for (const StructureBytes& structure : subject.tracer->bytes())
            of_variant.bytes += structure.bytes;
    }
    return times;
}

} // namespace romascope
