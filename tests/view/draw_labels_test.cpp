// Labels of the scene in the draw list.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/sensing/intensity.h"
#include "render/view/draw_list.h"
#include "tests/response_law.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::draw_labels_test {
namespace {

using namespace render;

Picture from_above() {
    Picture picture;
    const Rect window{0, 0, 1280, 800};
    picture.camera_view = look(Camera{}, Arena{}, nullptr, window, window);
    return picture;
}

std::vector<std::string> words(const Snapshot& now, const Picture& picture = from_above()) {
    DrawList list;
    fill(list, now, picture, Trails{});
    std::vector<std::string> texts;
    for (const Label& label : list.labels) texts.push_back(label.text);
    return texts;
}

bool has(const std::vector<std::string>& texts, const std::string& text) {
    return std::find(texts.begin(), texts.end(), text) != texts.end();
}

TEST(DrawLabels, LabelMetresAlongTheArena) {
    const auto texts = words(hand_made::empty(hand_made::scene()));
    for (const char* text : {"−10", "−5", "0", "5", "10 m"}) EXPECT_TRUE(has(texts, text)) << text;
}

TEST(DrawLabels, LabelHalfMetresAlongATable) {
    auto scene = hand_made::scene();
    scene->arena.width = scene->arena.height = 2;
    const auto texts = words(hand_made::empty(scene));
    for (const char* text : {"−100", "−50", "0", "50", "100 cm"}) EXPECT_TRUE(has(texts, text)) << text;
    EXPECT_FALSE(has(texts, "5"));
}

TEST(DrawLabels, KeepVehiclesAndBulbsFree) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, -3, -0.6f, 0);
    hand_made::add_source(now, Channel::light, 3, 0);
    DrawList list;
    fill(list, now, from_above(), Trails{});
    ASSERT_EQ(list.label_space.things().size(), 2U);
    const CameraView seen = from_above().camera_view;
    const auto vehicle = project(seen, {-3, -0.6f}), bulb = project(seen, {3, 0}, 0.4f);
    EXPECT_TRUE(list.label_space.things()[0].contains(vehicle->x, vehicle->y));
    EXPECT_TRUE(list.label_space.things()[1].contains(bulb->x, bulb->y));
}

TEST(LabelSpace, KeepsASlantedWallFreeButNotTheFloorBesideIt) {
    auto scene = hand_made::scene();
    scene->obstacles = {{.name = "wall", .length = 8, .width = 0.4f}};
    Snapshot now = hand_made::empty(scene);
    now.obstacles = {{0, 0, 0.7854f}};
    const CameraView seen = from_above().camera_view;
    LabelSpace space;
    space.keep_obstacles_free(now, seen);
    const auto is_free = [&](maths::vec2 place) {
        const maths::vec2 at = *project(seen, place);
        return space.is_free({at.x - 5, at.y - 5, 10, 10});
    };
    for (const float along : {-2.5f, 0.0f, 2.5f}) EXPECT_FALSE(is_free({along, along})) << along;
    EXPECT_TRUE(is_free({2, -2}));
    EXPECT_TRUE(is_free({-2, 2}));
}

TEST(LabelSpace, KeepsTheLineOfAPathFree) {
    LabelSpace space;
    const std::vector<maths::vec2> line{{100, 100}, {300, 200}, {300, 400}};
    space.keep_line_free(line, 4);
    EXPECT_FALSE(space.is_free({190, 140, 20, 20})) << "between two points";
    EXPECT_FALSE(space.is_free({290, 300, 20, 20}));
    EXPECT_TRUE(space.is_free({110, 160, 40, 40}));
    EXPECT_TRUE(space.is_free({310, 160, 40, 40}));
}

TEST(DrawLabels, NameShippedSourcesInTheLanguage) {
    auto scene = hand_made::scene();
    scene->sources = {{"bright", Channel::light, -3, 0}, {"my_own", Channel::light, 3, 0}};
    Snapshot now = hand_made::empty(scene);
    now.sources = {{0, Channel::light, -3, 0, 1}, {1, Channel::light, 3, 0, 1}};
    const NameMap german{{"bright", "hell"}};
    Picture picture = from_above();
    EXPECT_TRUE(has(words(now, picture), "bright"));
    picture.names = &german;
    EXPECT_TRUE(has(words(now, picture), "hell"));
    EXPECT_FALSE(has(words(now, picture), "bright"));
    EXPECT_TRUE(has(words(now, picture), "my own")) << "any other name as it is";
}

TEST(DrawLabels, DoNotOverlapTheWallsFromAnyAzimuth) {
    const Snapshot now = hand_made::empty(hand_made::scene());
    for (const float azimuth : {-1.57f, -1.2f, 0.4f, 2.0f})
        for (const float zoom : {0.5f, 1.0f, 3.0f}) {
            Picture picture = from_above();
            picture.pixel_scale = 2;
            Camera camera;
            camera.azimuth = azimuth, camera.zoom = zoom;
            picture.camera_view =
                look(camera, Arena{}, nullptr, picture.camera_view.window, picture.camera_view.window);
            DrawList list;
            fill(list, now, picture, Trails{});
            EXPECT_FALSE(list.labels.empty());
            for (const Label& label : list.labels) {
                // No edge of the wall (foot or top, inner or outer) extends past the anchor of the
                // label in the direction of the label.
                const auto at =
                    *project(picture.camera_view, label.place, label.height) + label.offset * picture.pixel_scale;
                EXPECT_NEAR(maths::length(label.away), 1, 1e-3);
                const maths::vec2 inside = label.place * (10 / (10 + 0.22f));
                for (const maths::vec2 edge : {label.place, inside})
                    for (const float height : {0.0f, 0.35f})
                        EXPECT_GE(maths::dot(at - *project(picture.camera_view, edge, height), label.away), 16)
                            << label.text << " from " << azimuth << " at " << zoom;
            }
        }
}

TEST(DrawLabels, OmitMetresAtLowElevations) {
    Picture picture = from_above();
    Camera camera;
    camera.elevation = 0.2f;
    picture.camera_view = look(camera, Arena{}, nullptr, picture.camera_view.window, picture.camera_view.window);
    EXPECT_TRUE(words(hand_made::empty(hand_made::scene()), picture).empty());
}

TEST(DrawLabels, NameSeveralSourcesAndEveryZoneExceptTape) {
    auto scene = hand_made::scene();
    scene->sources = {{.name = "north_lamp"}, {.name = "fire"}};
    scene->zones = {{.name = "ice_rink", .surface = Surface::ice},
                    {.name = "line1", .x = 3, .surface = Surface::tape},
                    {.name = "breeze", .y = 3, .surface = Surface::tape, .wind_x = 1}};
    Snapshot now = hand_made::empty(scene);
    hand_made::add_source(now, Channel::light, 0, 0);
    EXPECT_FALSE(has(words(now), "north lamp"));  // a single lamp has no name
    hand_made::add_source(now, Channel::heat, 5, 0);
    EXPECT_TRUE(has(words(now), "north lamp") && has(words(now), "fire") && has(words(now), "ice rink"));
    EXPECT_FALSE(has(words(now), "line1")) << "a line is made of many pieces";
    EXPECT_TRUE(has(words(now), "breeze"));
    Picture picture = from_above();
    picture.settings.overlays.surfaces = false;
    EXPECT_FALSE(has(words(now, picture), "ice rink"));
    picture.settings.overlays.labels = false;
    EXPECT_TRUE(words(now, picture).empty());
}

TEST(DrawLabels, NumberAllOfFewVehiclesAndTheSelectedOneOfMany) {
    Snapshot now = hand_made::empty(hand_made::scene());
    for (int i = 0; i < 3; ++i) hand_made::add(now, 0, static_cast<float>(i), 2, 0);
    EXPECT_TRUE(has(words(now), "1") && has(words(now), "3"));
    for (int i = 3; i < 40; ++i) hand_made::add(now, 0, static_cast<float>(i % 10), 3, 0);
    EXPECT_FALSE(has(words(now), "3"));
    Picture picture = from_above();
    picture.settings.selection.vehicle = 32;
    EXPECT_TRUE(has(words(now, picture), "33"));
}

TEST(DrawLabels, LabelContoursWithTheirValue) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add_source(now, Channel::light, -5, 0);
    sensing::IntensityMap map;
    map.update(intensity_input(now, Channel::light, no_vehicle));
    DrawList list;
    add_level_labels(list, map.grid(), now.scene->arena, {});
    ASSERT_EQ(list.labels.size(), 4U);  // from the lamp outwards
    const char* expected[] = {"0.8", "0.6", "0.4", "0.2"};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(list.labels[i].text, expected[i]);
        EXPECT_GT(list.labels[i].place.x, i > 0 ? list.labels[i - 1].place.x : -5);
        EXPECT_NEAR(reading_at(list.labels[i].place.x + 5), std::stof(expected[i]), 0.02);
    }
}

}  // namespace
}  // namespace braitenlab::tests::draw_labels_test
