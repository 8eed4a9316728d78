// Lines drawn with the mouse in a lecture.
#include <algorithm>
#include <cmath>

#include "lecture_on_desk.h"

namespace braitenlab::tests::lecture_marks_test {

using namespace ui;

namespace {

struct LectureMarks : testing::Test {
    Desk desk{1280, 800, 1, true};
    CameraView camera;

    LectureMarks() {
        desk.view.lecture = true;
        desk.frame(3);
        camera = look({}, desk.now.scene->arena, nullptr, desk.layout.window, desk.layout.scene);
        desk.view.camera_view = &camera;
        desk.frame(2);
    }
    void draw(ImVec2 from, ImVec2 to) {
        desk.point(from.x, from.y);
        desk.frame(2);
        desk.button(0, true);
        desk.frame(2);
        for (int i = 1; i <= 10; ++i) {
            const float t = static_cast<float>(i) / 10;
            desk.point(from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t);
            desk.frame();
        }
        desk.button(0, false);
        desk.frame(2);
    }
    // True if a line is drawn at this pixel.
    static bool draws_at(ImVec2 pixel) {
        const auto& drawn = ImGui::GetForegroundDrawList()->VtxBuffer;
        return std::any_of(drawn.begin(), drawn.end(), [&](const ImDrawVert& v) {
            return std::abs(v.pos.x - pixel.x) < 8 && std::abs(v.pos.y - pixel.y) < 8;
        });
    }
};

}  // namespace

TEST_F(LectureMarks, DDrawsLinesOnTheFloorUnderThePointer) {
    draw({500, 400}, {600, 450});
    EXPECT_TRUE(desk.panels.lecture.marks.lines.empty()) << "drawing is off";
    EXPECT_FALSE(desk.anchors.find("marks.sign"));
    desk.key({'D'});
    desk.frame(2);
    ASSERT_TRUE(desk.anchors.find("marks.sign"));
    const Rect sign = desk.where("marks.sign"), bar = desk.layout.toolbar;
    EXPECT_TRUE(sign.y >= bar.y && sign.y + sign.h <= bar.y + bar.h) << "it covers nothing that is drawn on";
    desk.all.clear();
    draw({500, 400}, {600, 450});
    ASSERT_EQ(desk.panels.lecture.marks.lines.size(), 1u);
    ASSERT_EQ(desk.panels.lecture.marks.lines[0].on, MarkedPart::floor);
    const auto& line = desk.panels.lecture.marks.lines[0].points;
    EXPECT_GE(line.size(), 10u);
    const auto first = project(camera, line.front()), last = project(camera, line.back());
    EXPECT_NEAR(first->x, 500, 1);
    EXPECT_NEAR(first->y, 400, 1);
    EXPECT_NEAR(last->x, 600, 1);
    EXPECT_NEAR(last->y, 450, 1);
    EXPECT_TRUE(desk.all.empty()) << "the mouse does nothing else";
    EXPECT_EQ(desk.panels.scene_input.drag.phase, SceneInputPhase::idle);
}

TEST_F(LectureMarks, ShiftDRemovesThemAndAnotherSceneToo) {
    desk.key({'D'});
    draw({500, 400}, {600, 450});
    draw({500, 300}, {600, 350});
    ASSERT_EQ(desk.panels.lecture.marks.lines.size(), 2u);
    desk.key({'D', false, true});
    EXPECT_TRUE(desk.panels.lecture.marks.lines.empty());
    draw({500, 400}, {600, 450});
    ASSERT_EQ(desk.panels.lecture.marks.lines.size(), 1u);
    ++desk.view.run_id;
    desk.frame();
    EXPECT_TRUE(desk.panels.lecture.marks.lines.empty());
    EXPECT_TRUE(desk.panels.lecture.marks.drawing) << "drawing stays on";
}

TEST_F(LectureMarks, EscapeEndsDrawingAndTheEndOfTheLectureToo) {
    desk.key({'D'});
    desk.all.clear();
    desk.key({key::escape});
    EXPECT_FALSE(desk.panels.lecture.marks.drawing);
    EXPECT_TRUE(desk.all.empty()) << "the lecture goes on";
    desk.key({'D'});
    draw({500, 400}, {600, 450});
    desk.view.lecture = false;
    desk.frame(2);
    EXPECT_FALSE(desk.panels.lecture.marks.drawing);
    EXPECT_TRUE(desk.panels.lecture.marks.lines.empty());
    desk.key({'D'});
    EXPECT_FALSE(desk.panels.lecture.marks.drawing) << "outside a lecture D has another meaning";
}

TEST_F(LectureMarks, DDrawsOverTheDiagram) {
    desk.now = shipped_scene("2a-coward");
    desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
    desk.view.settings.watching = true;
    desk.frame(3);
    const Rect canvas = desk.where("canvas"), label = desk.where("wire.LL");
    desk.key({'D'});
    desk.frame(2);
    desk.all.clear();
    const ImVec2 from{label.x + label.w / 2, label.y + label.h / 2};
    draw(from, {from.x + 40, from.y + 60});
    ASSERT_EQ(desk.panels.lecture.marks.lines.size(), 1u);
    EXPECT_TRUE(canvas.contains(from.x, from.y));
    EXPECT_EQ(desk.panels.lecture.marks.lines[0].on, MarkedPart::diagram);
    EXPECT_TRUE(desk.edits().empty()) << "the weight under the pen is not dragged";
    EXPECT_TRUE(draws_at(from));
}

TEST_F(LectureMarks, ALineOnTheDiagramStaysOnWhatItMarksWhenTheDiagramMoves) {
    desk.now = shipped_scene("2a-coward");
    desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
    LectureView pages = opened_lecture("four-numbers");
    pages.page = 2, pages.step = 1;
    ASSERT_FALSE(pages.shows(PagePart::values));
    ASSERT_TRUE(pages.shows(PagePart::wiring));
    desk.view.pages = &pages;
    desk.view.settings.watching = true;
    desk.frame(4);
    const auto middle = [&](const Rect& r) { return ImVec2{r.x + r.w / 2, r.y + r.h / 2}; };
    const ImVec2 before = middle(desk.where("wire.LL"));
    desk.key({'D'});
    desk.frame(2);
    draw(before, {before.x + 40, before.y + 60});
    ASSERT_TRUE(draws_at(before));
    pages.step = 2;
    desk.frame(6);
    ASSERT_TRUE(desk.anchors.find("lecture.speed")) << "the strip below";
    const ImVec2 after = middle(desk.where("wire.LL"));
    ASSERT_GT(std::hypot(after.x - before.x, after.y - before.y), 10) << "it makes room";
    EXPECT_TRUE(draws_at(after));
    desk.view.settings.watching = false;
    desk.frame(4);
    EXPECT_FALSE(draws_at(after)) << "not without the diagram";
}

TEST_F(LectureMarks, ALineOnTheValuesIsThereWhileTheyAreShown) {
    const Rect strip = desk.layout.hint_bar;
    const ImVec2 from{strip.x + 300, strip.y + 20};
    desk.key({'D'});
    desk.frame(2);
    draw(from, {from.x + 80, from.y + 10});
    ASSERT_EQ(desk.panels.lecture.marks.lines[0].on, MarkedPart::strip);
    EXPECT_TRUE(draws_at(from));
    LectureView pages = opened_lecture("four-numbers");
    desk.view.pages = &pages;
    desk.frame(4);
    EXPECT_FALSE(draws_at(from)) << "the page does not show them";
    desk.view.pages = nullptr;
    desk.frame(4);
    EXPECT_TRUE(draws_at(from));
}

TEST_F(LectureMarks, ALineOnAQuestionGoesWithItsCard) {
    LectureView pages = opened_lecture("four-numbers");
    pages.page = 1;
    desk.view.pages = &pages;
    desk.frame(4);
    const Rect card = desk.where("lecture.question");
    const ImVec2 from{card.x + 40, card.y + 60};
    desk.key({'D'});
    desk.frame(2);
    draw(from, {from.x + 80, from.y + 10});
    ASSERT_EQ(desk.panels.lecture.marks.lines[0].on, MarkedPart::question);
    EXPECT_TRUE(draws_at(from));
    pages.step = 2;
    ASSERT_TRUE(pages.shows(PagePart::answer));
    desk.frame(4);
    EXPECT_FALSE(draws_at(from)) << "the answer has its words elsewhere";
    pages.page = 3, pages.step = 0;
    desk.frame(4);
    ASSERT_TRUE(desk.anchors.find("lecture.question"));
    EXPECT_FALSE(draws_at(from)) << "another question";
    pages.page = 1;
    desk.frame(4);
    EXPECT_TRUE(draws_at(from));
    desk.view.pages = nullptr;
    desk.frame(4);
    EXPECT_FALSE(draws_at(from)) << "no card";
}

TEST_F(LectureMarks, ALineThatLeavesTheSceneGoesOnBesideIt) {
    desk.key({'D'});
    desk.frame(2);
    const Rect scene = desk.layout.scene;
    draw({scene.x + scene.w / 2, scene.y + scene.h - 40}, {scene.x + scene.w / 2, scene.y + scene.h + 30});
    const Rect strip = desk.layout.hint_bar;
    ASSERT_GT(strip.y, scene.y + scene.h) << "the line crosses the gap between scene and values";
    ASSERT_LT(strip.y, scene.y + scene.h + 30);
    std::vector<MarkedPart> parts;
    for (const MarkLine& line : desk.panels.lecture.marks.lines) {
        EXPECT_FALSE(line.points.empty());
        parts.push_back(line.on);
    }
    EXPECT_EQ(parts, (std::vector{MarkedPart::floor, MarkedPart::window, MarkedPart::strip}));
}

TEST_F(LectureMarks, TheBarCanBeClickedWhileTheMouseDraws) {
    desk.key({'D'});
    desk.frame(2);
    desk.click("button.play");
    EXPECT_EQ(desk.actions(), std::vector{Action::play_pause});
    EXPECT_TRUE(desk.panels.lecture.marks.lines.empty());
}

TEST_F(LectureMarks, DDrawsInTheWiringView) {
    desk.view.mode = Mode::wiring;
    desk.frame(2);
    desk.key({'D'});
    desk.frame(2);
    draw({500, 400}, {600, 450});
    ASSERT_EQ(desk.panels.lecture.marks.lines.size(), 1u);
    EXPECT_EQ(desk.panels.lecture.marks.lines[0].on, MarkedPart::diagram);
}

}  // namespace braitenlab::tests::lecture_marks_test
