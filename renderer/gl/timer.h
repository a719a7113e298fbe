// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/gl/debug.h"
#include "renderer/gl/objects.h"

#include <array>
#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace romascope {

/// How passes are timed.
enum class TimerClock {
    gpu_timestamps,  ///< 64-bit GL_TIMESTAMP queries, read when they are ready, never waited for
    cpu_with_finish, ///< glFinish and a CPU clock: a software rasteriser's own timestamps mislead
    none             ///< the driver has no timestamps
};

/// "gpu timestamps", "cpu clock with glFinish", "n/a".
std::string_view name_of(TimerClock clock);

/// The value below which the fraction `q` of the values lies, between neighbours by interpolation;
/// NaN if there are none.
double quantile(std::vector<double> values, double q);

/// Milliseconds of one pass over the frames that were timed.
struct PassTiming {
    std::string pass;
    bool rasterises = false; ///< draws triangles, as against compute only
    std::vector<double> milliseconds;
    int batch = 1; ///< how often the work was done for each time, which is that of one

    double median() const;
    double percentile_95() const;
};

/// Times passes by being around them. Passes do not nest.
class PassTimer {
public:
    /// Picks the clock for the current context.
    PassTimer();
    explicit PassTimer(TimerClock clock) : clock_(clock) {}

    TimerClock clock() const { return clock_; }

    /// A pass from construction to destruction: a debug group and a time.
    class Scope {
    public:
        Scope(PassTimer& timer, const std::string& pass, bool rasterises);
        ~Scope();
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

        /// Does the pass's work: once, or in batches as often as those ask. What it does the
        /// second time must be what it did the first time.
        template <class Work>
        void repeat(const Work& work) {
            repeats_ = timer_.begin_batch(pass_);
            for (int i = 0; i < repeats_; ++i)
                work();
        }

    private:
        PassTimer& timer_;
        DebugGroup group_;
        size_t pass_;
        int repeats_ = 1;
        std::chrono::steady_clock::time_point begin_;
        std::optional<std::array<GlHandle<delete_query>, 2>> queries_;
    };
    Scope compute(const std::string& pass) { return Scope(*this, pass, false); }
    Scope raster(const std::string& pass) { return Scope(*this, pass, true); }

    /// Takes in what queries are ready; called once a frame.
    void collect() { collect(false); }
    /// Waits for all queries; called once at the end.
    void finish() { collect(true); }
    /// Forgets what was measured, e.g. after warming up.
    void clear();
    /// Forgets what was measured, and from now on does the work of passes whose median was below
    /// `milliseconds` `batch` times for each of their times, which are divided by it: what a clock
    /// and an empty queue cost counts less then. Only passes that repeat() their work.
    void clear_and_batch(double milliseconds, int batch);
    /// Keeps no more than so many of the latest times of each pass; 0: all.
    void keep_latest(size_t count) { kept_ = count; }

    /// In the order in which the passes first ran.
    const std::vector<PassTiming>& timings() const { return timings_; }

private:
    struct Pending {
        size_t pass;
        int repeats;
        std::array<GlHandle<delete_query>, 2> queries;
    };
    size_t index_of(const std::string& pass, bool rasterises);
    int begin_batch(size_t pass); ///< how often its work is to be done
    GlHandle<delete_query> take_query();
    void collect(bool wait);
    void record(size_t pass, double milliseconds);

    TimerClock clock_;
    size_t kept_ = 0;
    std::vector<PassTiming> timings_;
    std::map<std::string, int> batches_; ///< of the passes that have one
    std::deque<Pending> pending_;        ///< the ring: as long as the GPU lags behind
    std::vector<GlHandle<delete_query>> free_queries_;
};

} // namespace romascope
