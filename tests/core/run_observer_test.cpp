#include "core/session/run_observer.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "core/io/run_file.h"
#include "core/session/session.h"
#include "core/world/cosmetic_edits.h"
#include "tests/core/sessions.h"

namespace braitenlab::tests::run_observer_test {
namespace {

// Counts ticks and commands, and digests what it has seen in order.
struct Digest {
    std::uint64_t tick = 0, ticks = 0, commands = 0, value = 0;
    bool begun = false;

    void add(std::uint64_t number) { value = (value ^ number) * 1099511628211u; }
    void watch(const Snapshot& now) {
        if (begun && now.tick == tick && now.tick > 0) return;
        if (now.tick == 0) *this = {};
        begun = true, tick = now.tick, ++ticks;
        add(now.tick);
        for (const VehicleView& v : now.vehicles) add(static_cast<std::uint64_t>(1e6f * (20 + v.x)));
    }
    void watch(const Snapshot& now, const Command& command) {
        EXPECT_EQ(now.tick, tick) << "a command comes after its tick";
        ++commands;
        add(command.index() + 100 * now.vehicles.size());
    }
    friend bool operator==(const Digest&, const Digest&) = default;
};
std::ostream& operator<<(std::ostream& out, const Digest& d) {
    return out << "tick " << d.tick << ": " << d.ticks << " ticks, " << d.commands << " commands, " << d.value;
}

Session observed(const Scene& scene = furnished(), std::uint64_t seed = 3) {
    auto session = Session::open(scene, seed, RunObserver::of(Digest{}));
    EXPECT_TRUE(session) << session.error().text();
    return std::move(*session);
}

const Digest& digest(const Session& session) { return *session.observer().as<Digest>(); }

// What sees the recorded run once, from its earliest tick to the present one. `begin`: what was seen before the
// earliest tick, which is not in the recording.
Digest straight(const Session& session, Digest begin = {}) {
    session.replay(session.earliest(), {[&](const Snapshot& now) { begin.watch(now); },
                                        [&](const Snapshot& now, const Command& command) {
                                            if (!world::is_cosmetic(command)) begin.watch(now, command);
                                        }});
    return begin;
}

void run(Session& session, int ticks) {
    for (int i = 0; i < ticks; ++i) session.step();
}

// Counts its copies.
struct Counted {
    static inline int copies = 0;
    Counted() = default;
    Counted(const Counted&) { ++copies; }
    Counted(Counted&&) = default;
    void watch(const Snapshot&) {}
    void watch(const Snapshot&, const Command&) {}
};

TEST(RunObserver, WithoutAWatcherHasNothingToShow) {
    RunObserver none;
    none.watch({});
    none.watch({}, AddVehicle{});
    EXPECT_FALSE(none);
    EXPECT_EQ(none.as<Digest>(), nullptr);
    EXPECT_EQ(RunObserver::of(Counted{}).as<Digest>(), nullptr) << "of another type";
}

TEST(RunObserver, IsCopiedOncePerKeyframeHoweverOftenTheRecordingIs) {
    auto session = Session::open(furnished(), 3, RunObserver::of(Counted{}));
    ASSERT_TRUE(session);
    run(*session, 10);
    Counted::copies = 0;
    run(*session, 290 + 300 + 20);
    EXPECT_EQ(Counted::copies, 2) << "at ticks 300 and 600";
    const Timeline left = session->timeline();
    const Bookmark here = session->bookmark();
    session->seek(450);
    ASSERT_FALSE(session->apply(AddVehicle{}));
    EXPECT_EQ(Counted::copies, 3) << "one goes on from tick 300";
}

TEST(RunObserver, SeesTheStartAndEachTickAndEachCommandThatIsNotCosmetic) {
    Session session = observed();
    EXPECT_EQ(digest(session).ticks, 1u);
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 1}));
    ASSERT_FALSE(session.apply(Retitle{"another"}));
    ASSERT_TRUE(session.apply(RemoveVehicle{999})) << "refused";
    EXPECT_EQ(digest(session).commands, 1u);
    run(session, 320);
    EXPECT_EQ(digest(session).ticks, 321u);
    ASSERT_FALSE(session.apply(AddVehicle{}));
    session.undo();
    session.redo();
    EXPECT_EQ(digest(session).commands, 4u);
    session.reset();
    EXPECT_EQ(digest(session).ticks, 1u);
    EXPECT_EQ(digest(session).commands, 0u);
}

// A moment to return to, and what had been seen when the recording of its bookmark begins.
struct Mark {
    Bookmark bookmark;
    Digest seen, before_keyframe;
};

Mark mark(const Session& session, const Digest& before_earliest) {
    Mark made{session.bookmark(), digest(session), before_earliest};
    const std::uint64_t keyframe = made.bookmark.checkpoint.keyframe_tick;
    session.replay(session.earliest(), {[&](const Snapshot& now) {
                                            if (now.tick < keyframe) made.before_keyframe.watch(now);
                                        },
                                        [&](const Snapshot& now, const Command& command) {
                                            const bool is_seen = now.tick < keyframe && !world::is_cosmetic(command);
                                            if (is_seen) made.before_keyframe.watch(now, command);
                                        }});
    return made;
}

// The observer has no function that a caller could forget to call: whatever the session does, it has seen what a
// straight replay of the recording shows.
TEST(RunObserver, HasSeenAStraightReplayOfTheRecordingHoweverTheSessionGotThere) {
    int returns = 0, undone = 0, past = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Session session = observed(furnished(), seed);
        maths::Random chance{seed, 5};
        const auto below = [&](std::uint64_t n) { return chance.next() % n; };
        std::vector<Mark> marks;
        struct Left {
            Timeline run;
            Digest seen, before_earliest;
        };
        std::vector<Left> left;
        Digest before_earliest;
        for (int i = 0; i < 30; ++i) {
            const std::uint64_t what = below(12);
            if (what < 3) run(session, static_cast<int>(below(160)));
            if (what >= 3 && what < 6) (void)session.apply(any_edit(session, chance), below(3));
            if (what == 6) undone += session.undo().done;
            if (what == 7) (void)session.redo();
            if (what == 8) session.seek(below(session.latest() + 1));
            if (what == 8) past += session.snapshot().tick < session.latest();
            if (what == 9) marks.push_back(mark(session, before_earliest));
            if (what == 10 && !marks.empty()) {
                const Mark& to = marks[below(marks.size())];
                session.go_to(to.bookmark);
                if (session.earliest() > 0) before_earliest = to.before_keyframe;
                ASSERT_EQ(digest(session), to.seen) << "seed " << seed << ", action " << i;
                ++returns;
            }
            const bool resets = what == 11 && (left.empty() || below(2) == 0);
            if (resets) {
                left.push_back({session.timeline(), digest(session), before_earliest});
                session.reset(below(2) == 0 ? Keep::edits : Keep::submission);
            } else if (what == 11) {
                const Left& to = left[below(left.size())];
                session.return_to(to.run);
                before_earliest = to.before_earliest;
                ASSERT_EQ(digest(session), to.seen) << "seed " << seed << ", action " << i;
                ++returns;
            }
            if (session.earliest() == 0) before_earliest = {};
            ASSERT_EQ(digest(session), straight(session, before_earliest))
                << "seed " << seed << ", action " << i << ": " << what;
        }
    }
    EXPECT_GT(returns, 40);
    EXPECT_GT(undone, 40);
    EXPECT_GT(past, 40);
}

TEST(RunObserver, RemembersTicksBeforeTheRecordedMinute) {
    Session session = observed();
    run(session, 4500);
    ASSERT_GT(session.earliest(), 0u);
    session.seek(session.earliest());
    EXPECT_EQ(digest(session).ticks, session.earliest() + 1);
    session.seek(4321);
    EXPECT_EQ(digest(session).ticks, 4322u);
}

// More commands than a keyframe holds create a keyframe, and a replay does not repeat them.
TEST(RunObserver, RemembersCommandsThatCreatedAKeyframe) {
    for (const int ticks : {0, 100, 300}) {
        Session session = observed();
        run(session, ticks);
        for (int i = 0; i < 600; ++i) ASSERT_FALSE(session.apply(MoveSource{0, 0.001f * static_cast<float>(i), 1}, 7));
        const auto at = static_cast<std::uint64_t>(ticks);
        ASSERT_EQ(session.snapshot().tick, at);
        EXPECT_EQ(digest(session).commands, 600u);
        const Digest there = digest(session);
        run(session, 50);
        const Digest later = digest(session);
        session.seek(at + 50);
        EXPECT_EQ(digest(session), later);
        session.seek(at);
        EXPECT_EQ(digest(session), there);
        run(session, 50);
        EXPECT_EQ(digest(session), later) << "the same ticks, repeated";
        if (ticks == 0) continue;
        session.seek(at - 1);
        EXPECT_EQ(digest(session).commands, 0u);
        run(session, 51);
        EXPECT_EQ(digest(session), later);
    }
}

TEST(RunObserver, ForgetsAnEditInThePastWhenItsUndoRestoresTheFuture) {
    for (const std::uint64_t at : {20u, 300u})
        for (const int moves : {1, 600}) {
            Session session = observed();
            run(session, 700);
            const Digest then = digest(session);
            session.seek(at);
            const Digest before = digest(session);
            for (int i = 0; i < moves; ++i)
                ASSERT_FALSE(session.apply(MoveSource{0, 0.001f * static_cast<float>(i), 1}, 7));
            EXPECT_EQ(digest(session).commands, static_cast<std::uint64_t>(moves));
            ASSERT_TRUE(session.undo_brings_time_back());
            session.undo();
            EXPECT_EQ(digest(session), before) << moves << " moves at tick " << at;
            session.seek(700);
            EXPECT_EQ(digest(session), then) << moves << " moves at tick " << at;
        }
}

TEST(RunObserver, OfASavedRunContinuesAsIfTheSessionHadNotEnded) {
    for (const int moves : {1, 600}) {
        Session session = observed();
        run(session, 310);
        for (int i = 0; i < moves; ++i) ASSERT_FALSE(session.apply(MoveSource{0, 0.001f * static_cast<float>(i), 1}));
        run(session, 30);
        auto saved = io::read_run(io::write_run(session.save()), "a.run");
        ASSERT_TRUE(saved) << saved.error().text();
        Session again = Session::resume(std::move(*saved), session.observer_at_keyframe());
        EXPECT_EQ(digest(again), digest(session));
        run(session, 300), run(again, 300);
        EXPECT_EQ(digest(again), digest(session));
        EXPECT_EQ(again.hash(), session.hash());
        again.seek(again.earliest()), session.seek(again.earliest());
        EXPECT_EQ(digest(again), digest(session));
    }
}

}  // namespace
}  // namespace braitenlab::tests::run_observer_test
