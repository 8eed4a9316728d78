#include "core/session/recording.h"

#include <gtest/gtest.h>

#include "core/session/session.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::recording_test {
namespace {

Session open() {
    auto session = Session::open(tests::crowd(12), 3);
    EXPECT_TRUE(session);
    return std::move(*session);
}

// A vehicle is dragged in circles: one command per frame, all in one step of undo.
void drag(Session& session, int frames) {
    for (int i = 0; i < frames; ++i) {
        const float along = static_cast<float>(i % 89) * 0.05f;
        ASSERT_FALSE(session.apply(MoveVehicle{4, along - 2, 1 - along, along}, 77));
    }
}

TEST(Recording, StaysSmallDuringALongDragInAPausedRun) {
    Session session = open();
    for (int i = 0; i < 130; ++i) session.step();
    drag(session, 4000);
    EXPECT_LT(session.bookmark().checkpoint.commands.size(), keyframe_commands);
    EXPECT_EQ(session.undo_depth(), 1);
    session.seek(100);
    session.seek(130);
    EXPECT_LT(session.bookmark().checkpoint.commands.size(), keyframe_commands);
}

TEST(Recording, ReplaysALongDragExactly) {
    Session session = open();
    std::vector<std::uint64_t> hashes;
    for (int tick = 0; tick < 700; ++tick) {
        if (tick == 130 || tick == 300) drag(session, 1300);
        if (tick == 300) {
            ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 1.5f}));
        }
        hashes.push_back(session.hash());
        session.step();
    }
    for (const std::uint64_t from : {0u, 129u, 130u, 131u, 299u, 300u, 301u, 650u}) {
        session.seek(from);
        ASSERT_EQ(session.hash(), hashes[from]) << from;
        for (std::uint64_t tick = from + 1; tick < 500; ++tick) {
            session.step();
            ASSERT_EQ(session.hash(), hashes[tick]) << "from " << from << " to " << tick;
        }
        EXPECT_EQ(session.latest(), 700u);
    }
    session.seek(131);
    World world = World::restore(session.save().checkpoint);
    while (world.tick() < 299) world.step();
    EXPECT_EQ(world.hash(), hashes[299]);
}

}  // namespace
}  // namespace braitenlab::tests::recording_test
