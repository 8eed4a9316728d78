#include "app/jobs/jobs.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

#if BRAITENLAB_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

namespace braitenlab {

namespace jobs {

#if BRAITENLAB_TBB

constexpr bool has_threads = true;

// Threads of oneTBB. They end with this object.
class Workers {
public:
    explicit Workers(int threads)
        : limit_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads) + 1) {
        constexpr int reserved = 0;  // no slot for the window's thread: it never works in the arena
        arena_.emplace(threads, reserved);
    }
    ~Workers() {
        arena_.reset();
        tbb::finalize(scheduler_, std::nothrow);
    }

    template <class Task>
    void start(Task task) {
        arena_->enqueue(std::move(task));
    }

private:
    tbb::task_scheduler_handle scheduler_{tbb::attach{}};
    tbb::global_control limit_;
    std::optional<tbb::task_arena> arena_;
};

#else

constexpr bool has_threads = false;

class Workers {
public:
    explicit Workers(int) {}
    template <class Task>
    void start(Task) {}
};

#endif

Work::Work(std::size_t parts) : parts_(parts), fractions_(new std::atomic<float>[parts] {}) { shown.parts = parts; }

JobProgress Work::progress() const {
    JobProgress now{.done = done.load(std::memory_order_relaxed), .parts = parts_};
    float sum = 0;
    for (std::size_t part = 0; part < parts_; ++part) sum += fractions_[part].load(std::memory_order_relaxed);
    now.fraction = parts_ == 0 ? 1 : sum / static_cast<float>(parts_);
    return now;
}

Error error_of(std::exception_ptr exception) {
    try {
        std::rethrow_exception(exception);
    } catch (const std::exception& e) {
        return {std::string("a background job failed: ") + e.what()};
    } catch (...) {
        return {"a background job failed: unknown exception"};
    }
}

namespace {

// Marks a part as complete and reduces after the last one.
void complete(Work& work, std::size_t part) {
    work.set_fraction(part, 1);
    if (work.done.fetch_add(1, std::memory_order_acq_rel) + 1 < work.parts() || work.cancelled) return;
    work.reduce();
    work.is_reduced.store(true, std::memory_order_release);
}

}  // namespace

}  // namespace jobs

struct Jobs::Impl {
    using Work = std::shared_ptr<jobs::Work>;
    struct Part {
        Work work;
        std::size_t index = 0;
    };

    explicit Impl(int worker_threads) : threads(worker_threads) {
        if (threads == 0) return;
        workers.emplace(threads);
    }

    // Takes the next part of the job whose turn it is; a begun part comes before a new one, so that at most one part
    // per thread is begun. Nullopt when none waits. Caller holds the mutex.
    std::optional<Part> take() {
        while (!queue.empty()) {
            Part part{std::move(queue.front())};
            queue.pop_front();
            jobs::Work& work = *part.work;
            if (work.cancelled) continue;
            if (work.begun.empty()) {
                part.index = work.next++;
            } else {
                part.index = work.begun.front();
                work.begun.pop_front();
            }
            work.queued = !work.begun.empty() || work.next < work.parts();
            if (work.queued) enqueue_again(part.work);
            return part;
        }
        return std::nullopt;
    }

    // Caller holds the mutex.
    void put_back(const Part& part) {
        part.work->begun.push_back(part.index);
        if (!std::exchange(part.work->queued, true)) enqueue_again(part.work);
    }

    // A job that is new. Caller holds the mutex.
    void enqueue(Work work) {
        if (work->order == jobs::Order::first)
            queue.push_front(std::move(work));
        else
            queue.push_back(std::move(work));
    }
    // A job that has had its turn. Caller holds the mutex.
    void enqueue_again(Work work) {
        if (work->order == jobs::Order::in_turns)
            queue.push_back(std::move(work));
        else
            queue.push_front(std::move(work));
    }

    // One step of the job whose turn it is; false when there is none. Caller holds the mutex, which is free meanwhile.
    bool run_step(std::unique_lock<std::mutex>& lock) {
        const auto part = take();
        if (!part) return false;
        lock.unlock();
        const bool is_complete = part->work->step(part->index);
        if (is_complete) jobs::complete(*part->work, part->index);
        lock.lock();
        if (!is_complete) put_back(*part);
        return true;
    }

    // Body of a worker thread.
    void run_all() {
        std::unique_lock lock(mutex);
        while (run_step(lock)) {
        }
        --running;
        changed.notify_all();
    }

    // Returns when no worker thread runs a step.
    void wait() {
        std::unique_lock lock(mutex);
        changed.wait(lock, [this] { return running == 0; });
    }

    void publish() {
        std::erase_if(submitted, [](const Work& work) {
            const bool is_reduced = work->is_reduced.load(std::memory_order_acquire);
            work->shown = work->progress();
            work->delivered = is_reduced;
            return is_reduced || work->cancelled;
        });
    }

    const int threads;
    std::vector<Work> submitted;  // not yet delivered; used by the window's thread only

    std::mutex mutex;                 // guards queue, running, and queued, next, begun of each job
    std::deque<Work> queue;           // jobs with parts that wait, each once
    int running = 0;                  // calls of run_all() that are started and have not returned
    std::condition_variable changed;  // `running` has decreased

    std::optional<jobs::Workers> workers;  // destroyed first
};

int Jobs::default_threads() {
    if (!jobs::has_threads) return 0;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
}

Jobs::Jobs(int threads) : impl_(std::make_unique<Impl>(jobs::has_threads ? std::max(0, threads) : 0)) {}

Jobs::~Jobs() {
    for (const auto& work : impl_->submitted) work->cancelled = true;
    impl_->wait();
}

int Jobs::threads() const { return impl_->threads; }

void Jobs::add(std::shared_ptr<jobs::Work> work) {
    Impl& impl = *impl_;
    impl.submitted.push_back(work);
    if (work->parts() == 0) {
        work->reduce();
        work->is_reduced = true;
        return;
    }
    const std::scoped_lock lock(impl.mutex);
    const std::size_t parts = work->parts();
    impl.enqueue(std::move(work));
    for (std::size_t i = 0; i < parts && impl.running < impl.threads; ++i) {
        ++impl.running;
        impl.workers->start([&impl] { impl.run_all(); });
    }
}

bool Jobs::work(std::chrono::nanoseconds budget) {
    using Clock = std::chrono::steady_clock;
    if (threads() > 0) return false;
    std::unique_lock lock(impl_->mutex);
    auto begun = Clock::now();
    const auto end = begun + budget;
    while (impl_->run_step(lock)) {
        const auto now = Clock::now();
        const auto step = now - std::exchange(begun, now);
        if (now + step > end) break;
    }
    return !impl_->queue.empty();
}

bool Jobs::step() {
    std::unique_lock lock(impl_->mutex);
    return impl_->run_step(lock);
}

void Jobs::publish() { impl_->publish(); }

void Jobs::deliver(std::chrono::nanoseconds budget) {
    work(budget);
    publish();
}

void Jobs::finish() {
    if (threads() == 0) {
        std::unique_lock lock(impl_->mutex);
        while (impl_->run_step(lock)) {
        }
    }
    impl_->wait();
    publish();
}

}  // namespace braitenlab
