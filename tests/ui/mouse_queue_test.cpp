#include "ui/mouse_queue.h"

#include <string>
#include <vector>

#include "desk.h"

namespace braitenlab::tests::mouse_queue_test {

using namespace ui;
using maths::vec2;

namespace {

constexpr int left = 0, right = 1;
constexpr vec2 here{100, 50}, there{400, 300};

// A press and a release in one place, and on to another place, all between two frames.
void click_and_leave(MouseQueue& queue, vec2 at, vec2 then, double seconds = 1) {
    queue.move(at);
    queue.press(left, seconds, {});
    queue.release(left);
    queue.move(then);
}

}  // namespace

TEST(MouseQueue, KeepsAClickAtItsPositionIfThePointerMovesOnWithinTheFrame) {
    MouseQueue queue;
    click_and_leave(queue, here, there);
    const MouseOfAFrame pressed = queue.take(), released = queue.take(), gone = queue.take();
    EXPECT_EQ(pressed.at, here);
    EXPECT_TRUE(pressed.down[left]);
    EXPECT_EQ(released.at, here);
    EXPECT_FALSE(released.down[left]);
    EXPECT_EQ(gone.at, there);
}

TEST(MouseQueue, AClickTakesTwoFramesAndEarlierMovementsNone) {
    MouseQueue queue;
    for (float x = 0; x < 100; ++x) queue.move({x, 50});
    queue.move(here);
    queue.press(left, 1, {});
    EXPECT_EQ(queue.take().at, here);
    queue.release(left);
    EXPECT_FALSE(queue.take().down[left]);
}

TEST(MouseQueue, AQuickDragIsPressedMovedAndReleasedInThreeFrames) {
    MouseQueue queue;
    queue.move(here);
    queue.press(left, 1, {});
    queue.move({200, 200});
    queue.move(there);
    queue.release(left);
    const MouseOfAFrame pressed = queue.take(), moved = queue.take(), released = queue.take();
    EXPECT_EQ(pressed.at, here);
    EXPECT_EQ(moved.at, there);
    EXPECT_TRUE(moved.down[left]) << "the drag has arrived before it ends";
    EXPECT_EQ(released.at, there);
    EXPECT_FALSE(released.down[left]);
}

TEST(MouseQueue, MergesMovementsOfADrag) {
    MouseQueue queue;
    queue.move(here);
    queue.press(left, 1, {});
    queue.take();
    for (float x = 101; x < 300; ++x) queue.move({x, 50});
    EXPECT_EQ(queue.take().at, (vec2{299, 50}));
    EXPECT_TRUE(queue.take().down[left]) << "held without events";
}

TEST(MouseQueue, MarksTheSecondPressOfADoubleClickWithinAFrame) {
    MouseQueue queue;
    click_and_leave(queue, here, here, 1.0);
    click_and_leave(queue, here, there, 1.1);
    std::vector<bool> twice, down;
    for (int i = 0; i < 5; ++i) {
        const MouseOfAFrame frame = queue.take();
        twice.push_back(frame.double_clicked), down.push_back(frame.down[left]);
    }
    EXPECT_EQ(down, (std::vector{true, false, true, false, false}));
    EXPECT_EQ(twice, (std::vector{false, false, true, false, false}));
}

TEST(MouseQueue, AddsTurnsOfTheWheelUnlessThePointerMovesAway) {
    MouseQueue queue;
    queue.move(here);
    for (int i = 0; i < 3; ++i) queue.turn_wheel({0, 1}), queue.move(here + vec2{static_cast<float>(i), 0});
    EXPECT_EQ(queue.take().wheel, (vec2{0, 3}));
    queue.turn_wheel({0, -1});
    queue.move(there);
    const MouseOfAFrame turned = queue.take(), moved = queue.take();
    EXPECT_EQ(turned.wheel, (vec2{0, -1}));
    EXPECT_NE(turned.at, there);
    EXPECT_EQ(moved.at, there);
    EXPECT_EQ(moved.wheel, vec2{}) << "it turns in one frame only";
}

TEST(MouseQueue, APressAfterATurnOfTheWheelIsInTheNextFrame) {
    MouseQueue queue;
    queue.move(here);
    queue.turn_wheel({0, 1});
    queue.press(left, 1, {});
    const MouseOfAFrame turned = queue.take(), pressed = queue.take();
    EXPECT_EQ(turned.wheel, (vec2{0, 1}));
    EXPECT_FALSE(turned.down[left]);
    EXPECT_TRUE(pressed.down[left]);
}

TEST(MouseQueue, GivesModifiersAtThePressAndNoneLater) {
    MouseQueue queue;
    queue.press(right, 1, {.shift = true});
    const MouseOfAFrame pressed = queue.take();
    ASSERT_TRUE(pressed.modifiers);
    EXPECT_TRUE(pressed.modifiers->shift);
    EXPECT_FALSE(queue.take().modifiers);
}

TEST(MouseQueue, ReleasesWhatIsDownOnlyAndLeavesTheWindow) {
    MouseQueue queue;
    queue.move(here);
    queue.press(left, 1, {});
    queue.press(right, 1, {});
    EXPECT_TRUE(queue.is_down(right));
    queue.release_all();
    EXPECT_FALSE(queue.any_down());
    queue.release(left);
    queue.leave();
    for (const bool down : {true, true, false, false}) EXPECT_EQ(queue.take().down[left], down);
    EXPECT_FALSE(queue.take().at);
}

TEST(MouseQueue, AFrameForAPictureHasThePointerOutsideAndKeepsTheButtons) {
    MouseQueue queue;
    queue.move(here);
    queue.press(left, 1, {});
    queue.take();
    queue.release(left);
    EXPECT_TRUE(queue.outside().down[left]);
    EXPECT_FALSE(queue.outside().at);
    const MouseOfAFrame next = queue.take();
    EXPECT_EQ(next.at, here);
    EXPECT_FALSE(next.down[left]) << "the event was kept";
}

// The same queue with widgets.
struct MovedOn : testing::Test {
    Desk desk;
    MouseQueue queue;

    MovedOn() {
        expect_queued_input(ImGui::GetIO());
        desk.frame(3);
    }
    vec2 middle(const char* anchor) const {
        const Rect r = desk.where(anchor);
        return {r.x + r.w / 2, r.y + r.h / 2};
    }
    void see(int frames) {
        for (; frames > 0; --frames) {
            hand_over(queue.take(), ImGui::GetIO());
            desk.frame();
        }
    }
};

TEST_F(MovedOn, AClickOnAButtonCounts) {
    for (int i = 0; i < 8; ++i) {
        click_and_leave(queue, middle("button.play"), there, 10.0 * i);
        see(4);
        desk.rest();
    }
    EXPECT_EQ(desk.actions(), std::vector<Action>(8, Action::play_pause));
}

TEST_F(MovedOn, ADragOnASliderSetsTheValueOfItsEndAndNoLaterOne) {
    std::vector<float> weights;
    for (const float way : {60.0f, 90.0f}) {
        const Rect track = desk.where("slider.LL");
        const vec2 from{track.x + track.w * 0.4f, track.y + track.h / 2};
        queue.move(from);
        queue.press(left, 1.0 + static_cast<double>(way), {});
        queue.move(from + vec2{way, 0});
        queue.release(left);
        queue.move(there);
        see(5);
        const auto edits = desk.edits();
        ASSERT_FALSE(edits.empty()) << way;
        weights.push_back(turned(edits.back()).value);
        desk.all.clear();
        see(3);
        EXPECT_TRUE(desk.edits().empty()) << "the slider does not follow the pointer after the release";
        desk.rest();
    }
    EXPECT_GT(weights[1], weights[0] + 0.1f);
}

TEST(MouseQueue, CountsTheChangesOfButtonsThatAFrameHasGot) {
    MouseQueue queue;
    queue.move({1, 1});
    queue.press(0, 0, {});
    queue.release(0);
    EXPECT_EQ(queue.changes(), 2u);
    EXPECT_EQ(queue.shown_changes(), 0u);
    queue.take();
    EXPECT_EQ(queue.shown_changes(), 1u);
    queue.take();
    EXPECT_EQ(queue.shown_changes(), 2u);
}

}  // namespace braitenlab::tests::mouse_queue_test
