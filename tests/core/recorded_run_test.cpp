// Recorded ticks, repeated beside their session.
#include "core/session/recorded_run.h"

#include "tests/core/sessions.h"

namespace braitenlab::tests::recorded_run_test {
namespace {

// A run with random edits: each tick's vehicles.
struct Edited {
    Session session = open_session(furnished());
    std::vector<std::vector<VehicleView>> seen;

    Edited() {
        maths::Random chance(5, 0);
        for (int i = 0; i < 900; ++i) {
            if (i % 37 == 0) (void)session.apply(any_edit(session, chance));
            seen.push_back(session.snapshot().vehicles);
            session.step();
        }
    }
};

void expect_same(const std::vector<VehicleView>& run, const std::vector<VehicleView>& recorded, std::uint64_t tick) {
    ASSERT_EQ(run.size(), recorded.size()) << "tick " << tick;
    for (std::size_t i = 0; i < run.size(); ++i) {
        EXPECT_EQ(run[i].x, recorded[i].x) << "tick " << tick;
        EXPECT_EQ(run[i].heading, recorded[i].heading) << "tick " << tick;
    }
}

TEST(RecordedRun, RepeatsARunWithEditsBitForBit) {
    Edited edited;
    for (const std::uint64_t from : {0U, 1U, 333U, 600U}) {
        RecordedRun run(edited.session.recording(), from);
        for (std::uint64_t tick = from; tick < edited.seen.size(); ++tick, run.step()) {
            ASSERT_EQ(run.tick(), tick);
            expect_same(run.snapshot().vehicles, edited.seen[tick], tick);
        }
    }
}

TEST(RecordedRun, LeavesTheSessionAsItIsAndOutlivesIt) {
    auto edited = std::make_unique<Edited>();
    const std::uint64_t before = edited->session.hash();
    RecordedRun run(edited->session.recording(), 100);
    run.step();
    EXPECT_EQ(edited->session.hash(), before);
    const auto expected = edited->seen[102];
    edited.reset();
    run.step();
    expect_same(run.snapshot().vehicles, expected, 102);
}

TEST(RecordedRun, GoesOnAfterTheLastRecordedTickAsTheSessionDoes) {
    Session session = open_session(crowd(4));
    RecordedRun run(session.recording(), 0);
    for (int i = 0; i < 200; ++i) run.step(), session.step();
    expect_same(run.snapshot().vehicles, session.snapshot().vehicles, 200);
}

TEST(RecordedRun, BeginsAfterTheLastRecordedTickToo) {
    Session session = open_session(crowd(4));
    const RecordedRun run(session.recording(), 90);
    EXPECT_EQ(run.tick(), 90U);
    for (int i = 0; i < 90; ++i) session.step();
    expect_same(run.snapshot().vehicles, session.snapshot().vehicles, 90);
}

TEST(RecordedRun, BeginsAtTheEarliestRecordedTickIfAnEarlierOneIsWanted) {
    Session session = open_session(crowd(2));
    for (std::uint64_t i = 0; i < recorded_ticks + 1200; ++i) session.step();
    ASSERT_GT(session.earliest(), 0U);
    EXPECT_EQ(RecordedRun(session.recording(), 0).tick(), session.earliest());
}

TEST(RecordedRun, GivesThePathOfEachVehicle) {
    Session session = open_session(crowd(3));
    std::vector<maths::vec2> first;
    for (int i = 0; i <= 125; ++i) {
        const VehicleView& v = session.snapshot().vehicles[0];
        if (i >= 20 && (i % 10 == 0 || i == 125)) first.push_back({v.x, v.y});
        session.step();
    }
    const auto paths = recorded_paths(session.recording(), 20, 125, 10);
    ASSERT_EQ(paths.size(), 3U);
    const auto& path = paths.at(session.snapshot().vehicles[0].id).places;
    EXPECT_EQ(paths.at(session.snapshot().vehicles[0].id).last.x, path.back().x);
    ASSERT_EQ(path.size(), first.size());
    for (std::size_t i = 0; i < path.size(); ++i) EXPECT_EQ(path[i].x, first[i].x);
}

}  // namespace
}  // namespace braitenlab::tests::recorded_run_test
