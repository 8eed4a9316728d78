// The predicted path, the last run and the cause of a turn over the scene; what the pointer tries out.
#include "ui/scene_input/draw_insight.h"

#include <algorithm>

#include "core/brain/four_neurons.h"
#include "core/insight/why.h"
#include "render/view/deck.h"
#include "render/view/drawing.h"
#include "scene_on_desk.h"

namespace braitenlab::tests::draw_insight_test {

struct DrawInsight : SceneOnDesk {
    const std::vector<std::vector<Pose>> no_fan{};
    std::vector<Pose> path{};

    DrawInsight() {
        for (int i = 0; i <= 480; ++i) path.push_back({-6 + 0.02f * static_cast<float>(i), -3, 0});
        desk.now.tick = 100;
        desk.frame(2);
    }
};

TEST_F(DrawInsight, ThePredictedPathEndsWhereTheVehicleWillBe) {
    EXPECT_FALSE(desk.anchors.find("stage.prediction"));
    desk.view.features.prediction = PredictionView{.path = &path, .fan = &no_fan, .tick = 100};
    desk.frame();
    const Rect at = desk.where("stage.prediction");
    const maths::vec2 end = pixel({path.back().x, path.back().y});
    EXPECT_NEAR(at.x + at.w / 2, end.x, 1);
    EXPECT_NEAR(at.y + at.h / 2, end.y, 1);
}

TEST_F(DrawInsight, TheComingPathHasADotEachHalfSecond) {
    constexpr std::size_t between = 30;
    desk.now.tick = 90;
    desk.now.vehicles.resize(1);
    Camera close;
    close.zoom = 2, close.pan = {-2, -3};
    camera_view = look(close, desk.now.scene->arena, nullptr, {0, 0, 1280, 800}, desk.layout.scene);
    const auto drawn_at = [&](std::size_t i) {
        const maths::vec2 at = pixel({path[i].x, path[i].y});
        for (const ImDrawVert& vertex : ImGui::GetBackgroundDrawList()->VtxBuffer)
            if (maths::distance(at, {vertex.pos.x, vertex.pos.y}) < 8) return true;
        return false;
    };
    desk.frame();
    for (std::size_t i = 120; i < 240; i += between) ASSERT_FALSE(drawn_at(i)) << i;
    desk.view.features.prediction = PredictionView{.path = &path, .fan = &no_fan, .tick = 90};
    desk.frame();
    for (std::size_t i = 120; i < 240; i += between) {
        EXPECT_TRUE(drawn_at(i)) << i;
        EXPECT_FALSE(drawn_at(i + between / 2)) << i;
    }
}

TEST_F(DrawInsight, ASourceOutsideThePictureHasAMarkAtTheEdge) {
    EXPECT_FALSE(desk.anchors.find("stage.outside.0"));
    Camera close;
    close.zoom = 4, close.pan = {4, -4};  // the lamp is to the upper left
    camera_view = look(close, desk.now.scene->arena, nullptr, {0, 0, 1280, 800}, desk.layout.scene);
    desk.frame();
    const Rect area = desk.layout.scene, at = desk.where("stage.outside.0");
    EXPECT_LT(at.y, area.y + 10);
    EXPECT_GE(at.y, area.y);
    EXPECT_LT(at.x + at.w, area.x + area.w / 2);
    desk.now.sources[0].strength = 0;
    desk.frame();
    EXPECT_FALSE(desk.anchors.find("stage.outside.0")) << "it is off";
}

TEST_F(DrawInsight, APathFromALaterTickIsNotDrawn) {
    desk.view.features.prediction = PredictionView{.path = &path, .fan = &no_fan, .tick = 101};
    desk.frame();
    EXPECT_FALSE(desk.anchors.find("stage.prediction"));
}

TEST_F(DrawInsight, TheLastRunIsDrawnUnlessASolutionIs) {
    desk.view.features.last_run = GhostView{path[100], 1, 0.7f, &path, 101};
    desk.frame();
    const Rect at = desk.where("stage.last_run");
    EXPECT_NEAR(at.x + at.w / 2, pixel({path[100].x, path[100].y}).x, 1);
    desk.view.features.ghost = desk.view.features.last_run;
    desk.frame();
    EXPECT_FALSE(desk.anchors.find("stage.last_run"));
}

TEST_F(DrawInsight, TheWholeLastRunIsDrawnWhileTheNewOneWaits) {
    desk.now.tick = 0;
    desk.view.features.last_run = GhostView{path[0], 1, 0.7f, &path, 1};
    desk.view.mode = Mode::playing;
    desk.frame();
    EXPECT_NEAR(desk.where("stage.last_run").x + 12, pixel({path[0].x, path[0].y}).x, 1) << "its present place";
    desk.view.mode = Mode::paused;
    desk.frame();
    const Rect at = desk.where("stage.last_run");
    EXPECT_NEAR(at.x + at.w / 2, pixel({path.back().x, path.back().y}).x, 1);
    EXPECT_TRUE(desk.says(desk.strings("scene_input.last_run_end")));
}

TEST_F(DrawInsight, TheWordsOfTheLastRunCoverNoVehicle) {
    desk.view.features.last_run = GhostView{path[100], 1, 0.7f, &path, 101};
    const maths::vec2 ghost = pixel({path[100].x, path[100].y});
    int covered = 0;
    for (int k = 0; k < 12; ++k) {
        const maths::vec2 away{k % 2 == 0 ? 60.0f : -60.0f, 10.0f * static_cast<float>(k) - 55};
        const auto floor = unproject(camera_view, ghost + away);
        ASSERT_TRUE(floor);
        desk.now.vehicles[0].x = floor->x, desk.now.vehicles[0].y = floor->y;
        desk.frame();
        for (const ui::Written& w : desk.written)
            if (w.words == desk.strings("scene_input.last_run"))
                covered += w.rect.contains(ghost.x + away.x, ghost.y + away.y);
    }
    EXPECT_EQ(covered, 0);
}

TEST_F(DrawInsight, TheWordsOfTheLastRunAreNotBelowTheTools) {
    const Rect first = desk.where("tool.hand"), last = desk.where("tool.ruler");
    int shown = 0;
    for (const float y : {first.y + 8, first.y + first.h - 8, first.y + first.h + 10})
        for (float x = first.x + 16; x < last.x; x += 24) {
            const auto floor = unproject(camera_view, {x, y});
            ASSERT_TRUE(floor);
            std::vector<Pose> ends{{floor->x, floor->y, 0}};
            desk.view.features.last_run = GhostView{ends[0], 1, 0.7f, &ends, 1};
            desk.now.tick = 0, desk.view.mode = Mode::paused;
            desk.frame();
            for (const ui::Written& w : desk.written) {
                if (w.words != desk.strings("scene_input.last_run_end")) continue;
                ++shown;
                EXPECT_TRUE(w.rect.y >= first.y + first.h || w.rect.x >= last.x + last.w) << x << ", " << y;
            }
        }
    EXPECT_GT(shown, 20);
}

TEST_F(DrawInsight, TheWordsOfBothPathsDoNotOverlap) {
    std::vector<Pose> before = path;
    for (const float apart : {-0.61f, 0.61f}) {
        before.back().y = path.back().y + apart;
        desk.view.features.prediction =
            PredictionView{.path = &path, .fan = &no_fan, .tick = 100, .before = &before, .before_tick = 100};
        desk.frame();
        const ui::Written *coming = nullptr, *earlier = nullptr;
        for (const ui::Written& one : desk.written) {
            if (one.words.starts_with("in ")) coming = &one;
            if (one.words == desk.strings("scene_input.before")) earlier = &one;
        }
        ASSERT_TRUE(coming && earlier) << apart;
        EXPECT_GE(std::fabs(coming->rect.y - earlier->rect.y), coming->rect.h + 8) << apart;
    }
}

TEST_F(DrawInsight, WordsCoverNeitherOtherWordsNorVehiclesNorBulbs) {
    const std::vector<Pose> before = path;
    desk.now.tick = 0;
    desk.view.mode = Mode::playing;
    desk.view.features.slots.a = GhostView{path[0], 1, 0.7f, &path, 1};
    desk.view.features.slots.b = GhostView{{-5.7f, -3, 0}, 1, 0.7f, &path, 20};
    for (const maths::vec2 end : {maths::vec2{-3, 6}, {-4, 0}, {-2.4f, 5.4f}, {0, -4}}) {
        desk.view.features.last_run = GhostView{{end.x + 0.3f, end.y, 0}, 1, 0.7f, &path, 101};
        path.back() = {end.x, end.y, 0};
        desk.view.features.prediction = PredictionView{.path = &path, .fan = &no_fan, .tick = 0, .before = &before};
        desk.frame();
        const LabelSpace& labels = scene_input().labels;
        std::vector<Rect> words;
        for (const ui::Written& one : desk.written)
            if (one.words == desk.strings("scene_input.before") || one.words == desk.strings("scene_input.last_run") ||
                one.words == "A" || one.words == "B" || one.words.starts_with("in "))
                words.push_back(one.rect);
        ASSERT_EQ(words.size(), 5U) << end;
        const auto apart = [](const Rect& a, const Rect& b) {
            return a.x + a.w <= b.x || b.x + b.w <= a.x || a.y + a.h <= b.y || b.y + b.h <= a.y;
        };
        for (std::size_t i = 0; i < words.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) EXPECT_TRUE(apart(words[i], words[k])) << end << i << k;
            for (const Rect& thing : labels.things()) EXPECT_TRUE(apart(words[i], thing)) << end << i;
        }
    }
}

// The label of the predicted path, or null.
const ui::Written* label_of_path(const Desk& desk) {
    for (const ui::Written& one : desk.written)
        if (one.words.starts_with("in ")) return &one;
    return nullptr;
}

TEST_F(DrawInsight, TheLabelOfAPathIsBesideItsEndAndNotOnItsLine) {
    constexpr float padding = 8, reach = 40;
    desk.now.vehicles.resize(1);
    for (const maths::vec2 end : {maths::vec2{3.2f, 6.1f}, {-3, 5.6f}, {1, 1}, {-5.5f, -0.5f}, {6, -7}}) {
        path.clear();
        for (int i = 0; i <= 480; ++i) {
            const float t = static_cast<float>(i) / 480, turn = 3 * t;
            const maths::vec2 swing = maths::vec2{std::sin(6 * turn), std::cos(6 * turn) - 1} * (1 - t);
            path.push_back({end.x * t + swing.x, end.y * t + swing.y, 0});
        }
        desk.view.features.prediction = PredictionView{.path = &path, .fan = &no_fan, .tick = 100};
        desk.frame();
        const ui::Written* label = label_of_path(desk);
        ASSERT_TRUE(label) << end;
        const Rect frame{label->rect.x - padding, label->rect.y - padding / 2, label->rect.w + 2 * padding,
                         label->rect.h + padding};
        const maths::vec2 at = pixel({path.back().x, path.back().y});
        const maths::vec2 nearest{std::clamp(at.x, frame.x, frame.x + frame.w),
                                  std::clamp(at.y, frame.y, frame.y + frame.h)};
        EXPECT_LE(maths::distance(at, nearest), reach) << end;
        for (const Pose& pose : path) {
            const maths::vec2 point = pixel({pose.x, pose.y});
            ASSERT_FALSE(frame.contains(point.x, point.y)) << end;
        }
    }
}

TEST_F(DrawInsight, ALabelWithoutAFreePlaceNearIsLeftOut) {
    desk.view.features.prediction = PredictionView{.path = &path, .fan = &no_fan, .tick = 100};
    desk.frame();
    EXPECT_TRUE(label_of_path(desk));
    Camera close;
    close.zoom = 4, close.pan = {-6, 6};  // the end is under the cards on the right
    camera_view = look(close, desk.now.scene->arena, nullptr, {0, 0, 1280, 800}, desk.layout.scene);
    ASSERT_GT(pixel({path.back().x, path.back().y}).x, desk.layout.scene.x + desk.layout.scene.w + 50);
    desk.frame();
    EXPECT_FALSE(label_of_path(desk));
}

TEST_F(DrawInsight, ThePredictionHasNoTimeWhereItEndsNow) {
    desk.view.features.prediction = PredictionView{.path = &path, .fan = &no_fan, .tick = 100};
    desk.frame(2);
    EXPECT_TRUE(desk.says("in 8 s"));
    path.resize(10);
    desk.frame(2);
    EXPECT_FALSE(desk.says("in 0 s"));
    EXPECT_TRUE(desk.anchors.find("stage.prediction"));
}

TEST_F(DrawInsight, ThePredictionHasNoTimeWhereTheVehicleRests) {
    std::fill(path.begin(), path.end(), path.front());
    path.back().x += 0.1f;
    desk.view.features.prediction = PredictionView{.path = &path, .fan = &no_fan, .tick = 100};
    desk.frame(2);
    EXPECT_FALSE(desk.says("in 8 s"));
    path.back().x += 1;
    desk.frame(2);
    EXPECT_TRUE(desk.says("in 8 s"));
}

TEST_F(DrawInsight, TheLettersOfTwoBrainsAreNearerToTheirOwnVehicles) {
    desk.now.vehicles.resize(1);
    VehicleView& vehicle = desk.now.vehicles[0];
    vehicle.x = path[100].x, vehicle.y = path[100].y;
    desk.view.features.slots.a = GhostView{path[100], 1, 0.7f, &path, 101};
    const auto label = [&](std::string_view letter) {
        const auto found = std::find_if(desk.written.begin(), desk.written.end(),
                                        [&](const ui::Written& one) { return one.words == letter; });
        EXPECT_NE(found, desk.written.end()) << letter;
        return found == desk.written.end()
                   ? maths::vec2{}
                   : maths::vec2{found->rect.x + found->rect.w / 2, found->rect.y + found->rect.h / 2};
    };
    for (int turn = 0; turn < 12; ++turn)
        for (const float away : {0.4f, 0.8f, 1.4f, 2.5f}) {
            const maths::vec2 place =
                maths::vec2{vehicle.x, vehicle.y} + maths::from_polar(away, 0.5236f * static_cast<float>(turn));
            std::vector<Pose> other = path;
            other[100] = {place.x, place.y, 0};
            desk.view.features.slots.b = GhostView{other[100], 1, 0.7f, &other, 101};
            desk.frame();
            const maths::vec2 a = pixel({vehicle.x, vehicle.y}), b = pixel(place);
            EXPECT_LT(maths::distance(label("A"), a) + 6, maths::distance(label("A"), b)) << turn << " " << away;
            EXPECT_LT(maths::distance(label("B"), b) + 6, maths::distance(label("B"), a)) << turn << " " << away;
        }
}

TEST_F(DrawInsight, TheLabelOfAPathCoversNoPost) {
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->obstacles = {{.name = "left"}, {.name = "right"}};
    for (Obstacle& post : scene->obstacles) post.length = post.width = 0.3f;
    desk.now.scene = scene;
    desk.now.vehicles.resize(1);
    const maths::vec2 end = pixel({path.back().x, path.back().y});
    desk.view.features.prediction = PredictionView{.path = &path, .fan = &no_fan, .tick = 100};
    for (const maths::vec2 away : {maths::vec2{32, 24}, {32, -24}, {-32, 24}, {-32, -24}, {24, 40}}) {
        for (const float side : {1.0f, -1.0f}) {
            const auto one = unproject(camera_view, end + away, 0.2f), other = unproject(camera_view, end - away, 0.2f);
            ASSERT_TRUE(one && other);
            desk.now.obstacles = {{one->x, one->y, 0}, {other->x, other->y, side}};
            desk.frame();
            const ui::Written* label = label_of_path(desk);
            ASSERT_TRUE(label) << away;
            for (const maths::vec2 post : {end + away, end - away})
                EXPECT_FALSE(label->rect.contains(post.x, post.y)) << away;
        }
    }
}

TEST_F(DrawInsight, TheDotsOfTheLastRunHideNoVehicle) {
    desk.now.vehicles.resize(1);
    desk.view.features.last_run = GhostView{path[300], 1, 0.7f, &path, 301};
    VehicleView& vehicle = desk.now.vehicles[0];
    const auto dots_on = [&](const Pose& place) {
        vehicle.x = place.x, vehicle.y = place.y;
        desk.frame();
        const Rect body = picture_of(desk.now, camera_view, vehicle);
        const maths::vec2 middle{body.x + body.w / 2, body.y + body.h / 2};
        int count = 0;
        for (const Rect& dot : scene_input().labels.labels())
            if (dot.w < 8 && maths::distance(middle, {dot.x + dot.w / 2, dot.y + dot.h / 2}) < 0.4f * body.w) ++count;
        return count;
    };
    for (const std::size_t tick : {60U, 150U, 240U}) EXPECT_EQ(dots_on(path[tick]), 0) << tick;
}

TEST_F(DrawInsight, NoPathIsDrawnOverAVehicle) {
    desk.now.vehicles.resize(3);
    desk.now.tick = 100;
    desk.view.settings.selection.vehicle = no_vehicle;
    const std::vector<std::vector<Pose>> fan{path};
    const std::vector<Pose> before(path.begin(), path.begin() + 400);
    const auto stands_at = [&](std::size_t i, const Pose& place) {
        desk.now.vehicles[i].x = place.x, desk.now.vehicles[i].y = place.y;
    };
    stands_at(0, path[150]), stands_at(1, path.back()), stands_at(2, before.back());
    // Vertices over the inner part of the bodies.
    const auto drawn_over_bodies = [&] {
        desk.frame();
        int count = 0;
        for (const VehicleView& vehicle : desk.now.vehicles) {
            const Rect body = picture_of(desk.now, camera_view, vehicle);
            const maths::vec2 middle{body.x + body.w / 2, body.y + body.h / 2};
            for (const ImDrawVert& vertex : ImGui::GetBackgroundDrawList()->VtxBuffer)
                count += maths::distance(middle, {vertex.pos.x, vertex.pos.y}) < 0.35f * body.w;
        }
        return count;
    };
    EXPECT_EQ(drawn_over_bodies(), 0) << "without a path";
    desk.view.features.prediction =
        PredictionView{.path = &path, .fan = &fan, .tick = 100, .before = &before, .before_tick = 100};
    EXPECT_EQ(drawn_over_bodies(), 0) << "the coming seconds, and those before the edit";
    desk.view.features.prediction.reset();
    desk.view.features.slots.a = GhostView{path[200], 1, 0.7f, &path, 201};
    EXPECT_EQ(drawn_over_bodies(), 0) << "the run of slot A";
}

TEST_F(DrawInsight, TheDotsOfTheLastRunAreSmallWhereVehiclesAre) {
    desk.view.features.last_run = GhostView{path[300], 1, 0.7f, &path, 301};
    const auto size_of_dots = [&](float zoom) {
        Camera camera;
        camera.zoom = zoom;
        camera_view = look(camera, desk.now.scene->arena, nullptr, {0, 0, 1280, 800}, desk.layout.scene);
        desk.frame();
        float least = 1e9f;
        for (const Rect& label : scene_input().labels.labels()) least = std::min(least, label.w);
        return least;
    };
    const float near = size_of_dots(3), far = size_of_dots(0.7f);
    EXPECT_LT(far, 0.75f * near);
    EXPECT_LE(near, 6.01f);
}

TEST_F(DrawInsight, ABlockedVehicleIsNotSaidToDriveOn) {
    insight::Why why{.vehicle = desk.now.vehicles[0].id, .left = 0.4f, .right = 0.4f};
    desk.view.features.why = &why;
    desk.now.tick = 100;
    desk.view.mode = Mode::playing;
    desk.now.vehicles[0].speed = 0;
    desk.frame();
    const auto says = [&](std::string_view words) {  // also where a line ends in them
        std::string all;
        for (const ui::Written& one : desk.written) all += one.words + " ";
        return all.find(words) != std::string::npos;
    };
    EXPECT_TRUE(says("something is in its way"));
    EXPECT_FALSE(desk.says("straight on"));
    EXPECT_FALSE(desk.says("Wheel difference")) << "nothing but zeros";
    desk.now.vehicles[0].speed = 1;
    desk.frame();
    EXPECT_TRUE(desk.says("straight on"));
    desk.now.vehicles[0].speed = 0.01f;
    why.left = why.right = 0.02f;
    desk.frame();
    EXPECT_TRUE(desk.says("straight on")) << "its wheels hardly push: nothing is in its way";
    desk.now.vehicles[0].speed = -1;
    why.left = why.right = -0.4f;
    desk.frame();
    EXPECT_TRUE(says("straight back"));
    EXPECT_FALSE(says("straight on"));
    desk.now.vehicles[0].speed = 0;
    desk.frame();
    EXPECT_TRUE(says("something is in its way")) << "in reverse, too";
}

TEST_F(DrawInsight, TheCauseOfTheTurnKeepsALampInSight) {
    insight::Why why{.vehicle = desk.now.vehicles[0].id, .left = 0.6f, .right = 0.25f};
    why.bias = -0.35f;
    desk.view.features.why = &why;
    desk.now.sources.clear();
    desk.frame();
    const Rect callout = desk.where("why");
    const auto hidden = unproject(camera_view, {callout.x + callout.w / 2, callout.y + callout.h / 2});
    ASSERT_TRUE(hidden);
    desk.now.sources.resize(1);
    desk.now.sources[0].x = hidden->x, desk.now.sources[0].y = hidden->y;
    desk.frame();
    const Rect moved = desk.where("why");
    const maths::vec2 at = pixel(*hidden);
    EXPECT_FALSE(at.x > moved.x && at.x < moved.x + moved.w && at.y > moved.y && at.y < moved.y + moved.h);
}

TEST_F(DrawInsight, TheCauseOfTheTurnHasABarForEachSensorAndAddsUp) {
    insight::Why why{.vehicle = desk.now.vehicles[0].id, .left = 0.6f, .right = 0.25f};
    why.sensors = {{"SR", 0.56f, -0.28f}, {"SL", 0.2f, 0.03f}};
    why.bias = -0.06f, why.rest = -0.04f;
    desk.view.features.why = &why;
    desk.frame();
    ASSERT_TRUE(desk.anchors.find("why"));
    for (const char* words :
         {"Turns right", "faster by 0.35", "reads 0.56", "+0.28", "−0.03", "+0.06", "+0.04", "+0.35"})
        EXPECT_TRUE(desk.says(words)) << words;
    why.left = 0.1f, why.right = 0.3f, why.sensors = {}, why.bias = 0.2f, why.rest = 0;
    desk.frame();
    EXPECT_TRUE(desk.says("Turns left"));
    EXPECT_TRUE(desk.says("Mostly the bias"));
}

TEST_F(DrawInsight, TheCauseOfTheTurnNamesWhatItsSensorReads) {
    const VehicleView& vehicle = desk.now.vehicles[0];
    const maths::vec2 ahead = maths::direction(vehicle.heading);
    const maths::vec2 source = maths::vec2{vehicle.x, vehicle.y} + maths::rotate({3, -1.5f}, ahead);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->obstacles.clear();
    scene->sources = {{.name = "lamp_2", .x = source.x, .y = source.y}};
    desk.now.scene = scene;
    desk.now.sources = {{.source = 0, .x = source.x, .y = source.y}};
    insight::Why why{.vehicle = vehicle.id, .left = 0.6f, .right = 0.25f};
    why.sensors = {{"SR", 0.56f, -0.35f}};
    desk.view.features.why = &why;
    desk.frame(2);
    std::string all;
    for (const ui::Written& one : desk.written) all += one.words + " ";
    EXPECT_NE(all.find("reads 0.56 (lamp 2)"), std::string::npos) << all;
}

TEST_F(DrawInsight, TheCauseOfTheTurnShowsWholeNamesOfSensors) {
    insight::Why why{.vehicle = desk.now.vehicles[0].id, .left = 0.6f, .right = 0.25f};
    why.sensors = {{"a sensor with a long name", 0.56f, -0.28f}, {"SL", 0.2f, 0.03f}};
    desk.view.features.why = &why;
    desk.frame(2);
    ASSERT_TRUE(desk.anchors.find("why"));
    EXPECT_TRUE(desk.says("a sensor with a long name"));
    EXPECT_EQ(desk.shortened, 0);
}

TEST_F(DrawInsight, APresetUnderThePointerIsTriedOut) {
    desk.view.settings.selection.vehicle = desk.now.vehicles[0].id;
    desk.frame(2);
    EXPECT_TRUE(desk.panels.brain.what_if.empty());
    desk.click("button.presets");
    desk.frame(2);
    desk.point("preset.2a-coward");
    desk.frame(2);
    ASSERT_EQ(desk.panels.brain.what_if.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<SetBrain>(desk.panels.brain.what_if.front()));
    EXPECT_TRUE(desk.edits().empty()) << "nothing is changed";
}

// The wires of the deck are where plan_deck() places them, at the deck's height.
TEST_F(DrawInsight, AWireOnTheDeckUnderThePointerIsTriedOut) {
    VehicleView& vehicle = desk.now.vehicles[0];
    Camera close;
    close.mode = CameraMode::follow;
    camera_view = look(close, desk.now.scene->arena, &vehicle, {0, 0, 1280, 800}, desk.layout.scene);
    desk.view.settings.selection.vehicle = vehicle.id;
    const Kind& kind = kind_of(desk.now, vehicle);
    const BrainGraph& brain = *brain_of(desk.now, vehicle);
    const render::DeckPlan plan = render::plan_deck(brain, kind);
    ASSERT_FALSE(plan.wires.empty());
    for (const render::DeckWire& each : plan.wires) {
        const maths::vec2 own = each.from * 0.49f + each.bend * 0.42f + each.to * 0.09f;  // at 0.3 of the curve
        const maths::vec2 at =
            maths::vec2{vehicle.x, vehicle.y} + maths::rotate(own, maths::direction(vehicle.heading));
        const auto pixel = project(camera_view, at, render::deck_height * render::height_scale_of(kind.body));
        ASSERT_TRUE(pixel);
        desk.point(pixel->x, pixel->y);
        desk.frame(2);
        ASSERT_EQ(desk.panels.brain.what_if.size(), 1u);
        BrainGraph without = brain;
        without.wires[each.wire].cut = true;
        EXPECT_EQ(std::get<SetBrain>(desk.panels.brain.what_if.front()).brain, without);
        EXPECT_TRUE(desk.says("The path without"));
    }
    EXPECT_TRUE(desk.edits().empty()) << "nothing is changed";
    desk.point(5, 400);
    desk.frame(2);
    EXPECT_TRUE(desk.panels.brain.what_if.empty());
}

TEST_F(DrawInsight, AWireOfTheDiagramBesideTheSceneIsTriedOut) {
    desk.view.settings.selection.vehicle = desk.now.vehicles[0].id;
    desk.view.settings.watching = true;
    desk.frame(3);
    const BrainGraph& brain = *brain_of(desk.now, desk.now.vehicles[0]);
    const Wire& wire = brain.wires.front();
    desk.point("wire." + wire_name(brain, {wire.from, wire.to}));
    desk.frame(2);
    ASSERT_EQ(desk.panels.brain.what_if.size(), 1u);
    EXPECT_TRUE(find_wire(std::get<SetBrain>(desk.panels.brain.what_if.front()).brain, wire.from, wire.to)->cut);
}

TEST_F(DrawInsight, AWireOfTheWiringEditorIsTriedOutUnlessItIsDragged) {
    desk.view.settings.selection.vehicle = desk.now.vehicles[0].id;
    desk.view.mode = Mode::wiring;
    desk.frame(4);
    EXPECT_TRUE(desk.panels.brain.what_if.empty());
    const BrainGraph& brain = *brain_of(desk.now, desk.now.vehicles[0]);
    const Wire& wire = brain.wires.front();
    desk.point("wire." + wire_name(brain, {wire.from, wire.to}));
    desk.frame(2);
    ASSERT_EQ(desk.panels.brain.what_if.size(), 1u);
    EXPECT_TRUE(find_wire(std::get<SetBrain>(desk.panels.brain.what_if.front()).brain, wire.from, wire.to)->cut);
    desk.button(0, true);
    desk.frame(2);
    EXPECT_TRUE(desk.panels.brain.what_if.empty());
    desk.button(0, false);
    desk.frame(2);
    EXPECT_FALSE(desk.panels.brain.what_if.empty());
    desk.point(5, 5);
    desk.frame(2);
    EXPECT_TRUE(desk.panels.brain.what_if.empty());
}

TEST_F(DrawInsight, TheInsetOfTheWiringEditorSaysWhichWireIsTriedOut) {
    desk.view.settings.selection.vehicle = desk.now.vehicles[0].id;
    desk.view.mode = Mode::wiring;
    desk.frame(4);
    EXPECT_FALSE(desk.anchors.find("what_if"));
    const BrainGraph& brain = *brain_of(desk.now, desk.now.vehicles[0]);
    const Wire& wire = brain.wires.front();
    const std::string name = wire_name(brain, {wire.from, wire.to});
    desk.point("wire." + name);
    desk.frame(2);
    EXPECT_TRUE(desk.says("The path without " + name));
    const Rect inset = desk.where("viewport"), words = desk.where("what_if");
    EXPECT_TRUE(inset.contains(words.x, words.y));
    EXPECT_TRUE(inset.contains(words.x + words.w, words.y + words.h));
    desk.view.settings.overlays.prediction = 0;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("what_if")) << "no path is shown";
}

TEST_F(DrawInsight, ThePathWithoutAWireIsShownBesideTheWiringEditor) {
    desk.view.mode = Mode::wiring;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("stage.prediction"));
    desk.view.features.prediction = PredictionView{.path = &path, .fan = &no_fan};
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("stage.prediction"));
}

TEST_F(DrawInsight, TheViewMenuSetsTheSecondsOfThePath) {
    desk.choose("view", "prediction");
    for (const int seconds : {20, 0, 3, 8}) {
        ASSERT_TRUE(desk.last<OverlaysRequest>());
        EXPECT_EQ(desk.last<OverlaysRequest>()->overlays.prediction, seconds);
        desk.view.settings.overlays = desk.last<OverlaysRequest>()->overlays;
        desk.frame();
        desk.click("menu.view.prediction");
    }
}

TEST_F(DrawInsight, TheViewMenuStepsThroughTheColoursOfTrails) {
    desk.view.settings.selection.vehicle = desk.now.vehicles[0].id;
    desk.view.settings.overlays.trails = false;
    desk.choose("view", "trail_colour");
    std::vector<TrailColour> wanted{{TrailValue::wheels}, {TrailValue::speed}};
    for (const Sensor& sensor : kind_of(desk.now, desk.now.vehicles[0]).sensors)
        wanted.push_back({TrailValue::reading, sensor.name});
    wanted.push_back({});
    for (const TrailColour& colour : wanted) {
        ASSERT_TRUE(desk.last<OverlaysRequest>());
        EXPECT_EQ(desk.last<OverlaysRequest>()->overlays.trail_colour, colour);
        EXPECT_TRUE(desk.last<OverlaysRequest>()->overlays.trails) << "a colour is seen";
        desk.view.settings.overlays = desk.last<OverlaysRequest>()->overlays;
        desk.frame();
        desk.click("menu.view.trail_colour");
    }
}

TEST_F(DrawInsight, ALegendTellsValueAndUnitOfColouredTrails) {
    desk.frame();
    EXPECT_FALSE(desk.anchors.find("trail_legend")) << "plain";
    desk.view.settings.overlays.trail_colour = {TrailValue::speed};
    desk.frame(2);
    const Rect scene = desk.where("viewport"), legend = desk.where("trail_legend");
    EXPECT_TRUE(scene.contains(legend.x, legend.y));
    EXPECT_TRUE(scene.contains(legend.x + legend.w, legend.y + legend.h));
    EXPECT_TRUE(desk.says("m/s"));
    EXPECT_TRUE(desk.says("3.0")) << "top speed";
    desk.view.settings.overlays.trails = false;
    desk.frame();
    EXPECT_FALSE(desk.anchors.find("trail_legend")) << "no trails";
}

TEST_F(DrawInsight, TheDashedEdgeSaysWhatHappensThere) {
    const auto says = [&] {
        desk.frame();
        std::string all;
        for (const auto& w : desk.written) all += w.words + " ";
        return all.find(std::string(desk.strings("scene_input.torus"))) != std::string::npos;
    };
    EXPECT_FALSE(says()) << "an arena with walls";
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->arena.edge = Boundary::torus;
    desk.now.scene = scene;
    EXPECT_TRUE(says());
    desk.view.settings.overlays.labels = false;
    EXPECT_FALSE(says());
}

TEST_F(DrawInsight, TheWordsAboveTheDashedEdgeAreNeverBelowTheTools) {
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->arena.edge = Boundary::torus;
    desk.now.scene = scene;
    desk.frame();
    const auto caption = [&] {
        const auto found = std::find_if(desk.written.begin(), desk.written.end(), [&](const ui::Written& each) {
            return desk.strings("scene_input.torus").starts_with(each.words);
        });
        return found == desk.written.end() ? std::optional<Rect>{} : found->rect;
    };
    ASSERT_TRUE(caption());
    int seen = 0;
    for (float zoom = 0.6f; zoom < 2.4f; zoom += 0.05f)
        for (float azimuth = -0.6f; azimuth < 0.7f; azimuth += 0.1f) {
            Camera camera;
            camera.zoom = zoom, camera.azimuth += azimuth;
            camera_view = look(camera, scene->arena, nullptr, {0, 0, 1280, 800}, desk.layout.scene);
            desk.frame();
            const auto words = caption();
            if (!words) continue;
            ++seen;
            for (const auto& [id, rect] : desk.anchors.all())
                if (id.starts_with("tool.")) EXPECT_FALSE(rect.overlaps(*words)) << id << " at zoom " << zoom;
        }
    EXPECT_GT(seen, 20);
}

}  // namespace braitenlab::tests::draw_insight_test
