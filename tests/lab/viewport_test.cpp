// The slow orbit of the camera, and the scene behind the title page.
#include "app/viewport.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include <gtest/gtest.h>
#include <imgui.h>

#include "app/course/lab_lecture.h"
#include "app/title.h"
#include "opened_lab.h"
#include "render/view/label_space.h"
#include "ui/window.h"
#include "ui/window_layout.h"

namespace braitenlab::tests::viewport_test {
namespace {

using maths::vec2;

struct SlowOrbit : testing::Test {
    SlowOrbit() { ImGui::CreateContext(); }
    ~SlowOrbit() override { ImGui::DestroyContext(); }

    // Lets one second pass; returns how far the camera has turned, rad.
    float turn(const ui::SceneInputState& input = {}, CameraKeys keys = {}) {
        const float before = lab.view.camera.azimuth;
        const Rect window{0, 0, 1280, 800};
        aim(state, lab, window, window, 1);
        drive_camera(lab, state, input, keys, window, window, 1);
        return lab.view.camera.azimuth - before;
    }

    Lab lab = opened_lab("2a-coward");
    ViewportState state;
};

TEST_F(SlowOrbit, TheWiringEditorFramesThePathsOfTheWireUnderThePointer) {
    const Rect window{0, 0, 1280, 800}, inset{900, 500, 320, 240};
    const auto width = [&] {
        aim(state, lab, window, inset, 10);
        return state.framed.high.x - state.framed.low.x;
    };
    const VehicleView vehicle = lab.document.session.snapshot().vehicles[0];
    const Pose here{vehicle.x, vehicle.y, vehicle.heading}, there{vehicle.x + 1, vehicle.y, vehicle.heading};
    const float action = width();
    Jobs jobs(0);
    lab.predictions.path.ask({.run = lab.document.run_id, .vehicle = vehicle.id});
    lab.predictions.path.begin([&](const PredictionSubject&) {
        return jobs.submit([here, there] { return std::optional(insight::Path{here, there}); });
    });
    jobs.finish();
    lab.predictions.path.take();
    EXPECT_EQ(width(), action) << "only in the editor";
    lab.playback.mode = Mode::wiring;
    EXPECT_LT(width(), 0.8f * action);
    EXPECT_LE(state.framed.low.x, here.x);
    EXPECT_GE(state.framed.high.x, there.x);
    lab.predictions.path.forget();
    EXPECT_NEAR(width(), action, 0.01f);
}

TEST_F(SlowOrbit, GlidesToTheCameraOfThePageThatHomeRestores) {
    auto lecture = std::make_shared<Lecture>(*read_whole_lecture(*find_shipped("four-numbers")));
    lecture->pages[0].azimuth = 0.5f;
    open_lecture(lab, lecture);
    const Rect window{0, 0, 1280, 800};
    lab.view.camera.azimuth = 2;
    for (int i = 0; i < 10; ++i) aim(state, lab, window, window, 1);
    EXPECT_GT(state.age, 1);
    lab.view.camera = home_camera(lab);
    aim(state, lab, window, window, 0.02f);
    EXPECT_LT(state.age, 0.1f);
}

TEST_F(SlowOrbit, GlidesWhereAStepOfALectureMovesTheSceneAndNotOnAnotherPage) {
    const Rect window{0, 0, 1280, 800}, right{650, 200, 600, 500}, left{20, 200, 600, 500};
    const auto lamp = [&] { return project(state.camera_view, {0, 0})->x; };
    const auto rest = [&](const Rect& area) {
        for (int i = 0; i < 300; ++i) aim(state, lab, window, area, 1.0f / 60);
        return lamp();
    };
    const float from = rest(right), to = rest(left);
    ASSERT_LT(to, from - 300);
    rest(right);
    aim(state, lab, window, left, 1.0f / 60);
    EXPECT_NEAR(lamp(), to, 1) << "outside a lecture";
    begin_lecture(lab);
    rest(right);
    float before = lamp();
    for (int frame = 0; frame < 60; ++frame) {
        aim(state, lab, window, left, 1.0f / 60);
        EXPECT_LE(before - lamp(), 0.3f * (from - to)) << "no jump in frame " << frame;
        before = lamp();
    }
    EXPECT_NEAR(before, rest(left), 1);
    rest(right);
    replace_document(lab, opened_lab("2a-coward").document);
    aim(state, lab, window, left, 1.0f / 60);
    EXPECT_NEAR(lamp(), rest(left), 1) << "another page";
}

TEST_F(SlowOrbit, FramesTheSceneBelowACardThatHidesAVehicle) {
    const Rect window{0, 0, 1280, 800}, area{16, 72, 1248, 600};
    const auto vehicle_at = [&] {
        for (int i = 0; i < 200; ++i) aim(state, lab, window, area, 1.0f / 60);
        const Snapshot& now = lab.document.session.snapshot();
        return picture_of(now, state.camera_view, now.vehicles[0]);
    };
    const Rect first = vehicle_at();
    const auto aim_below = [&](const Rect& card) {
        const Rect cards[]{card};
        for (int i = 0; i < 200; ++i) aim(state, lab, window, area, 1.0f / 60, {}, cards);
        const Snapshot& now = lab.document.session.snapshot();
        return picture_of(now, state.camera_view, now.vehicles[0]);
    };
    const Rect elsewhere = aim_below({first.x + first.w + 100, area.y, 60, 36});
    EXPECT_NEAR(elsewhere.x, first.x, 1) << "the card hides nothing";
    EXPECT_NEAR(elsewhere.y, first.y, 1);
    const float bottom = first.y + 0.6f * first.h;
    const Rect moved = aim_below({first.x - 20, area.y, first.w + 40, bottom - area.y});
    EXPECT_GE(moved.y, bottom - 1);
    EXPECT_NEAR(vehicle_at().y, first.y, 1) << "outside a lecture";
}

TEST_F(SlowOrbit, BesideTheQuestionAndTheDiagramOfALectureTheWholeArenaIsInThePicture) {
    const Rect window{0, 0, 1024, 768};
    const auto shows_arena = [&](Rect area) {
        for (int i = 0; i < 200; ++i) aim(state, lab, window, area, 1.0f / 60);
        const Arena& arena = lab.document.session.snapshot().scene->arena;
        bool all = true;
        for (const float x : {-0.5f, 0.5f})
            for (const float y : {-0.5f, 0.5f}) {
                const auto at = project(state.camera_view, {x * arena.width, y * arena.height});
                all &= at && area.contains(at->x, at->y);
            }
        return all;
    };
    constexpr Rect diagram{17, 213, 448, 532}, above_values{17, 213, 448, 403}, question{488, 213, 510, 532};
    for (const char* scene : {"2a-coward", "2b-aggressor"})
        for (const Rect& area : {diagram, above_values, question}) {
            SCOPED_TRACE(scene + std::string(" ") + std::to_string(area.w));
            lab = opened_lab(scene);
            EXPECT_FALSE(shows_arena(area)) << "outside a lecture the action is larger";
            begin_lecture(lab);
            EXPECT_TRUE(shows_arena(area));
            lab.view.camera.zoom = 2;
            EXPECT_FALSE(shows_arena(area)) << "the camera of the user";
        }
}

TEST_F(SlowOrbit, ACardThatTakesAColumnOfTheSceneDoesNotMoveItDown) {
    const Rect window{0, 0, 1280, 800}, area{16, 72, 1248, 600};
    for (int i = 0; i < 200; ++i) aim(state, lab, window, area, 1.0f / 60);
    const Snapshot& now = lab.document.session.snapshot();
    const Rect vehicle = picture_of(now, state.camera_view, now.vehicles[0]);
    const float beside = vehicle.x + vehicle.w + 10;
    const Rect card{area.x, area.y, beside - 10 - area.x, area.h}, cards[]{card};
    const Rect rest{beside, area.y, area.x + area.w - beside, area.h};
    aim(state, lab, window, rest, 1.0f / 60, {}, cards);
    EXPECT_EQ(state.below_cards, 0);
}

namespace {

bool is_inside(const Rect& a, const Rect& b) {
    return a.x >= b.x && a.y >= b.y && a.x + a.w <= b.x + b.w && a.y + a.h <= b.y + b.h;
}

// Whether the area shows all vehicles, also a second later at their present speed.
bool shows_vehicles(const Snapshot& now, const CameraView& seen, const Rect& area) {
    return std::all_of(now.vehicles.begin(), now.vehicles.end(), [&](VehicleView vehicle) {
        const bool is_shown = is_inside(picture_of(now, seen, vehicle), area);
        const vec2 way = maths::direction(vehicle.heading) * vehicle.speed;
        vehicle.x += way.x, vehicle.y += way.y;
        return is_shown && is_inside(picture_of(now, seen, vehicle), area);
    });
}

// Whether the area shows what makes the selected vehicle turn.
bool shows_nearest_source(const Lab& lab, const CameraView& seen, const Rect& area) {
    const Snapshot& now = lab.document.session.snapshot();
    const VehicleView* vehicle = find_vehicle(now, lab.view.selection.vehicle);
    if (!vehicle) return true;
    const SourceView* nearest = nullptr;
    const auto distance = [&](const SourceView& s) { return std::hypot(s.x - vehicle->x, s.y - vehicle->y); };
    for (const SourceView& s : now.sources)
        if (s.strength != 0 && (!nearest || distance(s) < distance(*nearest))) nearest = &s;
    return !nearest || is_inside(picture_of(now, seen, *nearest), area);
}

Rect free_area_of(const Lab& lab, const Rect& window) {
    const float scale = ui::fitting_scale(1, window, lab.before_lecture.has_value());
    const LabView view = view_of(lab);
    return ui::lay_out(window.w, window.h, scale, view, ui::open_cards(view, {})).scene;
}

void each_exercise(const std::function<void(const std::string&)>& look_at) {
    int count = 0;
    for (const auto& file :
         std::filesystem::directory_iterator(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "guided"))
        look_at(file.path().stem().string()), ++count;
    EXPECT_GT(count, 20);
}

constexpr Rect windows[]{{0, 0, 800, 600}, {0, 0, 1280, 800}, {0, 0, 1024, 768}};

}  // namespace

TEST_F(SlowOrbit, ThePictureOfAnExerciseRestsWhileItShowsAllVehicles) {
    for (const bool lecture : {false, true})
        each_exercise([&](const std::string& name) {
            for (const Rect& window : windows) {
                SCOPED_TRACE(name + (lecture ? " in a lecture, " : ", ") + std::to_string(static_cast<int>(window.w)));
                lab = opened_lab(name), state = {};
                if (lecture) begin_lecture(lab);
                lab.preferences.reduce_motion = true;  // the picture is that to which the camera would glide
                const Rect area = free_area_of(lab, window);
                const auto frame = [&] { aim(state, lab, window, area, 1.0f / 60); };
                frame();
                int moved = 0, unseen = 0;
                for (int i = 0; i < 30 * 60; ++i) {
                    tick(lab);
                    const Snapshot& now = lab.document.session.snapshot();
                    const bool rests = shows_vehicles(now, state.camera_view, area) &&
                                       shows_nearest_source(lab, state.camera_view, area);
                    const FloorBox before = state.framed;
                    frame();
                    moved += rests && !(state.framed == before);
                    unseen += std::any_of(now.vehicles.begin(), now.vehicles.end(), [&](const VehicleView& vehicle) {
                        return !area.contains(*project(state.camera_view, {vehicle.x, vehicle.y}));
                    });
                }
                EXPECT_EQ(moved, 0) << "times the picture has moved without need";
                EXPECT_EQ(unseen, 0) << "frames in which a vehicle is not in the free area";
            }
        });
}

TEST_F(SlowOrbit, ShowsWhatAnExerciseIsAboutWhenItOpensAndAfterAReset) {
    for (const bool lecture : {false, true})
        each_exercise([&](const std::string& name) {
            for (const Rect& window : windows) {
                SCOPED_TRACE(name + (lecture ? " in a lecture, " : ", ") + std::to_string(static_cast<int>(window.w)));
                lab = opened_lab(name), state = {};
                if (lecture) begin_lecture(lab);
                const Rect area = free_area_of(lab, window);
                const auto expect_shown = [&](const char* when) {
                    for (int i = 0; i < 300; ++i) aim(state, lab, window, area, 1.0f / 60);
                    const Snapshot& now = lab.document.session.snapshot();
                    for (const VehicleView& vehicle : now.vehicles)
                        EXPECT_TRUE(is_inside(picture_of(now, state.camera_view, vehicle), area)) << when;
                    for (const Step& step : lab.document.lesson->exercise->steps)
                        if (const auto* ring = std::get_if<goals::Circles>(&step.check.goal))
                            for (const float angle : {0.0f, 1.6f, 3.1f, -1.6f}) {
                                const vec2 lamp{now.sources[0].x, now.sources[0].y};
                                const auto at = project(state.camera_view, lamp + maths::from_polar(ring->to, angle));
                                EXPECT_TRUE(at && area.contains(*at)) << when << ", the ring at " << angle;
                            }
                };
                expect_shown("open");
                for (int i = 0; i < 20 * 60; ++i) {
                    tick(lab);
                    if (i % 6 == 0) aim(state, lab, window, area, 0.1f);
                }
                handle(lab, Action::reset);
                expect_shown("after a reset");
            }
        });
}

TEST_F(SlowOrbit, TurnsTheCameraSlowlyUntilItIsStopped) {
    EXPECT_EQ(turn(), 0);
    handle(lab, Action::slow_orbit);
    EXPECT_GT(turn(), 0.02f);
    EXPECT_LT(turn(), 0.15f);
    EXPECT_FLOAT_EQ(lab.view.camera.zoom, 1);
    handle(lab, Action::slow_orbit);
    EXPECT_EQ(turn(), 0);
}

TEST_F(SlowOrbit, AnyInputForTheCameraStopsIt) {
    ui::SceneInputState drag;
    drag.drag.phase = ui::SceneInputPhase::orbit;
    ui::SceneInputState pan;
    pan.drag.phase = ui::SceneInputPhase::pan;
    const auto stops = [&](const ui::SceneInputState& input, CameraKeys keys) {
        lab.view.orbits = true;
        turn(input, keys);
        return !lab.view.orbits;
    };
    EXPECT_FALSE(stops({}, {}));
    EXPECT_TRUE(stops(drag, {}));
    EXPECT_TRUE(stops(pan, {}));
    EXPECT_TRUE(stops({}, {.turn = 1}));
    EXPECT_TRUE(stops({}, {.zoom = 1}));
    ImGui::GetIO().MouseWheel = 1;
    EXPECT_TRUE(stops({}, {}));
    ImGui::GetIO().MouseWheel = 0;
    for (const Action action : {Action::home, Action::follow, Action::birds_eye}) {
        lab.view.orbits = true;
        handle(lab, action);
        EXPECT_FALSE(lab.view.orbits) << static_cast<int>(action);
    }
}

TEST_F(SlowOrbit, DoesNotMoveWhereMotionIsReduced) {
    lab.preferences.reduce_motion = true;
    handle(lab, Action::slow_orbit);
    EXPECT_FALSE(lab.view.orbits);
    EXPECT_EQ(lab.notice.key, "unavailable.motion_reduced");
    lab.view.orbits = true;
    EXPECT_EQ(turn(), 0);
}

TEST_F(SlowOrbit, IsAboutTheWholeSceneAndEndsWithIt) {
    handle(lab, Action::follow);
    handle(lab, Action::slow_orbit);
    EXPECT_EQ(lab.view.camera.mode, CameraMode::overview);
    EXPECT_TRUE(lab.view.orbits);
    EXPECT_FALSE(for_another_scene(lab.view).orbits);
}

TEST(TitleScene, MovesUnlessMotionIsReduced) {
    int seen = 0;
    auto title = title_lab([&](const Snapshot&) { ++seen; });
    ASSERT_TRUE(title);
    EXPECT_GT(seen, 100) << "for paths that can be seen";
    EXPECT_FALSE(title->document.session.snapshot().vehicles.empty());
    title->preferences.reduce_motion = true;
    const auto tick = title->document.session.snapshot().tick;
    const Camera camera = title->view.camera;
    advance_title(*title, 0.1f);
    EXPECT_EQ(title->document.session.snapshot().tick, tick);
    EXPECT_EQ(title->view.camera, camera);
    title->preferences.reduce_motion = false;
    advance_title(*title, 0.1f);
    EXPECT_GT(title->document.session.snapshot().tick, tick);
    EXPECT_NE(title->view.camera.azimuth, camera.azimuth);
}

struct HideInLecture : testing::Test {
    Lab lab = opened_lab("2a-coward");
};

TEST_F(HideInLecture, KeysHideAndRevealOnlyInALectureWhoseEndRevealsAll) {
    handle(lab, Action::hide_brain);
    EXPECT_TRUE(lab.view.revealed.brain) << "not in a lecture";
    begin_lecture(lab);
    handle(lab, Action::hide_brain);
    handle(lab, Action::hide_title);
    EXPECT_EQ(lab.view.revealed, (Revealed{false, true, false}));
    handle(lab, Action::hide_title);
    handle(lab, Action::hide_character);
    EXPECT_EQ(lab.view.revealed, (Revealed{true, false, false}));
    end_lecture(lab);
    EXPECT_EQ(lab.view.revealed, Revealed{});
}

}  // namespace
}  // namespace braitenlab::tests::viewport_test
