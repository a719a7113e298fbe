// SPDX-License-Identifier: MIT
#include "renderer/gl/timer.h"

#include "renderer/gl/context.h"

#include <algorithm>
#include <cmath>

namespace romascope {
namespace {

TimerClock clock_for_current_context() {
    if (is_software_context())
        return TimerClock::cpu_with_finish;
    GLint bits = 0;
    glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    return bits > 0 ? TimerClock::gpu_timestamps : TimerClock::none;
}

} // namespace

double quantile(std::vector<double> values, double q) {
    if (values.empty())
        return std::nan("");
    std::sort(values.begin(), values.end());
    const double place = q * static_cast<double>(values.size() - 1);
    const auto below = static_cast<size_t>(place);
    const size_t above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], place - static_cast<double>(below));
}

std::string_view name_of(TimerClock clock) {
    switch (clock) {
    case TimerClock::gpu_timestamps:
        return "gpu timestamps";
    case TimerClock::cpu_with_finish:
        return "cpu clock with glFinish";
    case TimerClock::none:
        break;
    }
    return "n/a";
}

double PassTiming::median() const { return quantile(milliseconds, 0.5); }
double PassTiming::percentile_95() const { return quantile(milliseconds, 0.95); }

PassTimer::PassTimer() : clock_(clock_for_current_context()) {}

PassTimer::Scope::Scope(PassTimer& timer, const std::string& pass, bool rasterises)
    : timer_(timer), group_(pass), pass_(timer.index_of(pass, rasterises)) {
    if (timer_.clock_ == TimerClock::gpu_timestamps) {
        queries_ = {timer_.take_query(), timer_.take_query()};
        glQueryCounter((*queries_)[0].id(), GL_TIMESTAMP);
    } else if (timer_.clock_ == TimerClock::cpu_with_finish) {
        glFinish();
        begin_ = std::chrono::steady_clock::now();
    }
}

PassTimer::Scope::~Scope() {
    if (queries_) {
        glQueryCounter((*queries_)[1].id(), GL_TIMESTAMP);
        timer_.pending_.push_back({pass_, repeats_, std::move(*queries_)});
    } else if (timer_.clock_ == TimerClock::cpu_with_finish) {
        glFinish();
        const std::chrono::duration<double, std::milli> taken =
            std::chrono::steady_clock::now() - begin_;
        timer_.record(pass_, taken.count() / repeats_);
    }
}

void PassTimer::clear() {
    finish();
    timings_.clear();
}

void PassTimer::clear_and_batch(double milliseconds, int batch) {
    finish();
    for (const PassTiming& timing : timings_)
        if (timing.median() < milliseconds)
            batches_[timing.pass] = batch;
    timings_.clear();
}

void PassTimer::record(size_t pass, double milliseconds) {
    std::vector<double>& times = timings_[pass].milliseconds;
    times.push_back(milliseconds);
    if (kept_ > 0 && times.size() > kept_)
        times.erase(times.begin(), times.end() - static_cast<std::ptrdiff_t>(kept_));
}

size_t PassTimer::index_of(const std::string& pass, bool rasterises) {
    const auto found = std::find_if(timings_.begin(), timings_.end(), [&](const PassTiming& t) {
        return t.pass == pass && t.rasterises == rasterises;
    });
    if (found != timings_.end())
        return static_cast<size_t>(found - timings_.begin());
    timings_.push_back({pass, rasterises, {}});
    return timings_.size() - 1;
}

int PassTimer::begin_batch(size_t pass) {
    const auto batch = batches_.find(timings_[pass].pass);
    if (batch != batches_.end())
        timings_[pass].batch = batch->second;
    return timings_[pass].batch;
}

GlHandle<delete_query> PassTimer::take_query() {
    if (!free_queries_.empty()) {
        GlHandle<delete_query> query = std::move(free_queries_.back());
        free_queries_.pop_back();
        return query;
    }
    GLuint id = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &id);
    return GlHandle<delete_query>(id);
}

void PassTimer::collect(bool wait) {
    while (!pending_.empty()) {
        Pending& front = pending_.front();
        GLint ready = 0;
        glGetQueryObjectiv(front.queries[1].id(), GL_QUERY_RESULT_AVAILABLE, &ready);
        if (!ready && !wait)
            return;
        GLuint64 begin = 0, end = 0;
        glGetQueryObjectui64v(front.queries[0].id(), GL_QUERY_RESULT, &begin);
        glGetQueryObjectui64v(front.queries[1].id(), GL_QUERY_RESULT, &end);
        record(front.pass, static_cast<double>(end - begin) * 1e-6 / front.repeats);
        for (GlHandle<delete_query>& query : front.queries)
            free_queries_.push_back(std::move(query));
        pending_.pop_front();
    }
}

} // namespace romascope
