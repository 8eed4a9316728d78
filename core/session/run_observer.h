// RunObserver: a value of any type that follows a run tick by tick and goes back in time with it.
#pragma once

#include <memory>
#include <utility>

#include "core/world/command.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// Holds one copyable value, the watcher, or none. Copies share the watcher until one of them watches, so each keyframe
// of a recording has a copy of its own at the cost of a pointer.
//
// A watcher has two functions:
//   watch(const Snapshot&)                  the start of a run, then the end of each tick. Tick 0 begins a new run; the
//                                           tick watched last changes nothing.
//   watch(const Snapshot&, const Command&)  after a command that is not cosmetic. The snapshot has the tick watched
//                                           last.
// Its value must depend on these calls only, not on positions of nodes, title and story.
class RunObserver {
public:
    RunObserver() = default;

    template <class Watcher>
    static RunObserver of(Watcher watcher) {
        RunObserver observer;
        observer.held_ = std::make_shared<Holds<Watcher>>(std::move(watcher));
        return observer;
    }

    explicit operator bool() const { return held_ != nullptr; }

    // The watcher if it has this type, else null. Valid until the observer watches, is assigned or ends.
    template <class Watcher>
    const Watcher* as() const {
        const auto* held = dynamic_cast<const Holds<Watcher>*>(held_.get());
        return held ? &held->watcher : nullptr;
    }

    // Without a watcher these do nothing.
    void watch(const Snapshot& now) {
        if (held_) own().watch(now);
    }
    void watch(const Snapshot& after, const Command& command) {
        if (held_) own().watch(after, command);
    }

private:
    struct Held {
        Held() = default;
        Held(const Held&) = delete;
        Held& operator=(const Held&) = delete;
        virtual ~Held() = default;
        virtual void watch(const Snapshot&) = 0;
        virtual void watch(const Snapshot&, const Command&) = 0;
        virtual std::shared_ptr<Held> copy() const = 0;
    };
    template <class Watcher>
    struct Holds : Held {
        explicit Holds(Watcher w) : watcher(std::move(w)) {}
        void watch(const Snapshot& now) override { watcher.watch(now); }
        void watch(const Snapshot& after, const Command& command) override { watcher.watch(after, command); }
        std::shared_ptr<Held> copy() const override { return std::make_shared<Holds>(watcher); }
        Watcher watcher;
    };

    Held& own() {
        if (held_.use_count() > 1) held_ = held_->copy();
        return *held_;
    }

    std::shared_ptr<Held> held_;
};

}  // namespace braitenlab
