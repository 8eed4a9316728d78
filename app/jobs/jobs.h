// Background jobs: long work on separate worlds, outside a frame.
//
//     Jobs jobs;
//     Job<int> job = jobs.submit(10, [](std::size_t part) { return simulate(part); }, sum);
//
//     jobs.deliver(4ms);  // once per frame
//     if (const auto total = job.take()) show(*total);
//
// A job has independent parts, numbered from 0, and a reduction of their results in the order of these numbers. Its
// result does not depend on the number of threads.
//
// Parts run on worker threads. Jobs and Job are used from one thread, the window's.
#pragma once

#include <atomic>
#include <chrono>
#include <concepts>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/result.h"

namespace braitenlab {

struct JobProgress {
    std::size_t done = 0, parts = 0;  // complete parts, all parts
    float fraction = 0;               // 0..1, with the progress inside parts
};

// Implementation of jobs.h, shared with jobs.cpp; not for use elsewhere.
namespace jobs {

// When the steps of a job come: in turn with other jobs, before them, or after those of the jobs submitted before it
// and then without a turn of others, so that such jobs end one after the other.
enum class Order { in_turns, first, one_by_one };

// A job without its types. Each part is stepped by one thread at a time.
class Work {
public:
    explicit Work(std::size_t parts);
    virtual ~Work() = default;
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    // Runs one step of the part; true once the part is complete. Does not throw.
    virtual bool step(std::size_t part) = 0;
    // Call once, after the last part. Does not throw.
    virtual void reduce() = 0;

    std::size_t parts() const { return parts_; }
    void set_fraction(std::size_t part, float fraction) { fractions_[part].store(fraction, std::memory_order_relaxed); }
    JobProgress progress() const;

    std::atomic<bool> cancelled = false;
    std::atomic<std::size_t> done = 0;     // complete parts
    std::atomic<bool> is_reduced = false;  // the result exists

    Order order = Order::in_turns;

    // Guarded by the mutex of Jobs.
    bool queued = true;             // in the queue of jobs with parts that wait
    std::size_t next = 0;           // first part that is not begun
    std::deque<std::size_t> begun;  // parts between two steps

    // Used by the window's thread only.
    JobProgress shown;       // as of the last deliver()
    bool delivered = false;  // the result may be taken

private:
    std::size_t parts_;
    std::unique_ptr<std::atomic<float>[]> fractions_;
};

Error error_of(std::exception_ptr);

// What a part returns: a callable is a part in steps, anything else is the part's result.
template <class Begun>
struct PartTraits {
    static constexpr bool in_steps = false;
    using Value = Begun;
};
template <class Begun>
requires std::invocable<Begun&>
struct PartTraits<Begun> {
    static constexpr bool in_steps = true;
    using Value = typename std::invoke_result_t<Begun&>::value_type;
};

template <class T>
class TypedWork : public Work {
public:
    using Work::Work;
    std::optional<Result<T>> result;
};

template <class Begin, class Reduce, class T>
class WorkOf final : public TypedWork<T> {
public:
    WorkOf(std::size_t parts, Begin begin, Reduce reduction)
        : TypedWork<T>(parts), begin_(std::move(begin)), reduce_(std::move(reduction)), slots_(parts) {}

    bool step(std::size_t part) override {
        Slot& slot = slots_[part];
        try {
            if constexpr (Traits::in_steps) {
                if (!slot.step) slot.step.emplace(std::as_const(begin_)(part));
                slot.value = (*slot.step)();
                if (!slot.value) {
                    if constexpr (requires {
                                      { slot.step->progress() } -> std::convertible_to<float>;
                                  })
                        this->set_fraction(part, slot.step->progress());
                    return false;
                }
                slot.step.reset();
            } else {
                slot.value.emplace(std::as_const(begin_)(part));
            }
        } catch (...) {
            slot.error = error_of(std::current_exception());
        }
        return true;
    }

    void reduce() override {
        std::vector<Value> values;
        values.reserve(slots_.size());
        for (Slot& slot : slots_) {
            if (slot.error) {
                this->result.emplace(std::move(*slot.error));
                return;
            }
            values.push_back(std::move(*slot.value));
        }
        slots_.clear();
        try {
            this->result.emplace(reduce_(std::move(values)));
        } catch (...) {
            this->result.emplace(error_of(std::current_exception()));
        }
    }

private:
    using Begun = std::invoke_result_t<const Begin&, std::size_t>;
    using Traits = PartTraits<Begun>;
    using Value = typename Traits::Value;
    struct NoStep {};
    struct Slot {
        std::optional<std::conditional_t<Traits::in_steps, Begun, NoStep>> step;
        std::optional<Value> value;
        std::optional<Error> error;
    };
    Begin begin_;
    Reduce reduce_;
    std::vector<Slot> slots_;
};

}  // namespace jobs

// Handle of a submitted job. Destruction and assignment cancel the job. May outlive its Jobs.
template <class T>
class Job {
public:
    Job() = default;
    ~Job() { cancel(); }
    Job(Job&& other) noexcept = default;
    Job& operator=(Job&& other) noexcept {
        if (this != &other) cancel(), work_ = std::move(other.work_);
        return *this;
    }

    // True from submission until the result is taken or the job is cancelled.
    bool active() const { return work_ && !work_->cancelled.load(std::memory_order_relaxed); }

    // As of the last deliver(); zeros for a job that is not active.
    JobProgress progress() const { return active() ? work_->shown : JobProgress{}; }

    // The result, once, after the deliver() that follows the end of the job. An exception in a part or in the reduction
    // is an Error; of several parts, the first in their order.
    std::optional<Result<T>> take() {
        if (!active() || !work_->delivered) return std::nullopt;
        return std::exchange(std::exchange(work_, nullptr)->result, std::nullopt);
    }

    // Does not wait: a running step is completed. No further step begins, no result is delivered.
    void cancel() {
        if (work_) work_->cancelled.store(true, std::memory_order_relaxed);
        work_.reset();
    }

private:
    friend class Jobs;
    explicit Job(std::shared_ptr<jobs::TypedWork<T>> work) : work_(std::move(work)) {}
    std::shared_ptr<jobs::TypedWork<T>> work_;
};

// Long work is computed by several jobs at once, each replaced by the next frame after its end. Jobs take turns: jobs
// of one length would end together, and the threads would wait for that frame. These lengths keep their ends apart.
inline constexpr std::size_t jobs_at_once = 4;
constexpr std::size_t parts_of_next_job(std::size_t running, std::size_t most) {
    return most * (running + 1) / jobs_at_once;
}

class Jobs {
public:
    // Processors less one, which is left to the window, at least 1; 0 in a build without threads.
    static int default_threads();

    // threads: worker threads; 0: deliver() runs the jobs on the calling thread. A build without threads always does.
    explicit Jobs(int threads = default_threads());

    // Cancels all jobs and returns when no worker thread is left.
    ~Jobs();
    Jobs(const Jobs&) = delete;
    Jobs& operator=(const Jobs&) = delete;

    int threads() const;

    // begin(part) returns the result of part 0 ≤ part < parts, or a step: a callable that returns std::optional of the
    // result and is called until there is one. A step takes about a millisecond: between two steps the job can be
    // cancelled, and without threads a frame is drawn. A step with a member progress() reports 0..1.
    //
    // reduce receives the results as a std::vector in the order of the parts and returns the result of the job. It runs
    // once, on the thread that completes the last part.
    //
    // begin and reduce are called on any thread, begin on several at once: they own what they capture or share
    // constants.
    template <class Begin, class Reduce>
    auto submit(std::size_t parts, Begin begin, Reduce reduce) {
        return submit_parts(parts, std::move(begin), std::move(reduce), jobs::Order::in_turns);
    }

    // The result is the std::vector of the parts' results.
    template <class Begin>
    auto submit(std::size_t parts, Begin begin) {
        return submit(parts, std::move(begin), all_values);
    }

    // The same; of jobs submitted so, each begins when no part of those before it waits. Other jobs wait meanwhile.
    template <class Begin>
    auto submit_one_by_one(std::size_t parts, Begin begin) {
        return submit_parts(parts, std::move(begin), all_values, jobs::Order::one_by_one);
    }

    // The same; its steps come before those of other jobs.
    template <class Begin, class Reduce>
    auto submit_first(std::size_t parts, Begin begin, Reduce reduce) {
        return submit_parts(parts, std::move(begin), std::move(reduce), jobs::Order::first);
    }

    // A job of one part, which is this step. The result is the step's.
    template <std::invocable Step>
    auto submit(Step step) {
        return submit_step(std::move(step), jobs::Order::in_turns);
    }

    // The same; its steps come before those of other jobs.
    template <std::invocable Step>
    auto submit_first(Step step) {
        return submit_step(std::move(step), jobs::Order::first);
    }

    // Call once per frame. Without threads, runs steps, at least one, until another one as long as the last would end
    // after `budget`; jobs take turns. Then publishes progress and results.
    void deliver(std::chrono::nanoseconds budget);

    // Between two calls of deliver(): without threads, runs steps as deliver() does and publishes nothing. True while
    // steps wait.
    bool work(std::chrono::nanoseconds budget);

    // The two halves of deliver() for a thread that is not the window's: runs one step on the calling thread, beside
    // worker threads, too, and returns false where none waits; publishes progress and results without a step.
    bool step();
    void publish();

    // Runs every job to its end and delivers it.
    void finish();

private:
    static constexpr auto all_values = [](auto values) { return values; };

    template <class Step>
    auto submit_step(Step step, jobs::Order order) {
        using Value = typename jobs::PartTraits<Step>::Value;
        const auto begin = [held = std::make_shared<Step>(std::move(step))](std::size_t) { return std::move(*held); };
        const auto reduce = [](std::vector<Value> values) -> Value { return std::move(values.front()); };
        return submit_parts(1, begin, reduce, order);
    }

    template <class Begin, class Reduce>
    auto submit_parts(std::size_t parts, Begin begin, Reduce reduce, jobs::Order order) {
        using Value = typename jobs::PartTraits<std::invoke_result_t<const Begin&, std::size_t>>::Value;
        using T = std::invoke_result_t<Reduce&, std::vector<Value>>;
        auto work = std::make_shared<jobs::WorkOf<Begin, Reduce, T>>(parts, std::move(begin), std::move(reduce));
        work->order = order;
        add(work);
        return Job<T>(work);
    }

    void add(std::shared_ptr<jobs::Work>);
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace braitenlab
