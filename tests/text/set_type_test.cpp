#include "render/text/set_type.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "tests/view/hand_made.h"

namespace braitenlab::tests::set_type_test {
namespace {

using namespace render;

class SetType : public testing::Test {
protected:
    SetType() : lettering(std::move(*Lettering::from_fonts(find_font, 20))) {
        const Rect window{0, 0, 1280, 800};
        picture.camera_view = look(Camera{}, Arena{}, nullptr, window, window);
    }

    std::vector<LetterInstance> set(const std::vector<Label>& labels) {
        std::vector<LetterInstance> letters;
        set_type(letters, labels, lettering, picture);
        return letters;
    }
    static Rect around(const std::vector<LetterInstance>& letters) {
        Rect r{1e9f, 1e9f, 0, 0};
        float right = 0, bottom = 0;
        for (const auto& l : letters) {
            r.x = std::min(r.x, l.box.x), r.y = std::min(r.y, l.box.y);
            right = std::max(right, l.box.x + l.box.z), bottom = std::max(bottom, l.box.y + l.box.w);
        }
        r.w = right - r.x, r.h = bottom - r.y;
        return r;
    }

    Lettering lettering;
    Picture picture;
};

TEST_F(SetType, CentresALabelOnItsPosition) {
    for (const char* text : {"H", "HOXOH", "MMMMMMMMMM"}) {
        const Rect box = around(set({{{2, 3}, 0, {}, text, {}, 0}}));
        const maths::vec2 at = *project(picture.camera_view, {2, 3});
        EXPECT_NEAR(box.x + box.w / 2, at.x, 2) << text;
        EXPECT_NEAR(box.y + box.h / 2, at.y, 2) << text;
    }
}

TEST_F(SetType, WritesNoLabelUnderACard) {
    const maths::vec2 at = *project(picture.camera_view, {2, 3});
    picture.covered = {{at.x - 60, at.y - 20, 45, 40}};
    EXPECT_EQ(set({{{2, 3}, 0, {}, "H", {}, 0}}).size(), 1u) << "beside the card";
    EXPECT_TRUE(set({{{2, 3}, 0, {}, "MMMMMM", {}, 0}}).empty()) << "partly under it";
}

TEST_F(SetType, PutsCharactersOnWholePixelsAtAnyZoom) {
    for (const float zoom : {0.5f, 1.0f, 1.37f, 4.0f}) {
        Camera camera;
        camera.zoom = zoom;
        picture.camera_view = look(camera, Arena{}, nullptr, picture.camera_view.window, picture.camera_view.window);
        const auto letters = set({{{0.13f, 0.37f}, 0, {}, "lamp", {}, 0}});
        ASSERT_EQ(letters.size(), 4U);
        for (const auto& letter : letters) {
            EXPECT_EQ(letter.box.x, std::floor(letter.box.x));
            EXPECT_EQ(letter.box.y, std::floor(letter.box.y));
        }
    }
}

TEST_F(SetType, OmitsTheLessImportantOfTwoOverlappingLabels) {
    const std::vector<Label> labels{{{0, 0}, 0, {}, "metres", {}, 5}, {{0.1f, 0}, 0, {}, "x", {}, 0}};
    EXPECT_EQ(set(labels).size(), 1U);
    EXPECT_EQ(set({{{0, 0}, 0, {}, "far", {}, 5}, {{5, 0}, 0, {}, "x", {}, 0}}).size(), 4U);
}

TEST_F(SetType, PutsALabelElsewhereWhereItWouldCoverSomething) {
    const Label label{.place = {2, 3}, .text = "lamp", .elsewhere = {{0, {0, 40}}, {0, {0, -40}}}};
    const maths::vec2 at = *project(picture.camera_view, {2, 3});
    const auto row = [&](const LabelSpace& space, const std::vector<Label>& labels) {
        std::vector<LetterInstance> letters;
        set_type(letters, labels, lettering, picture, space);
        const Rect box = around(letters);
        return letters.empty() ? -1000.0f : box.y + box.h / 2 - at.y;
    };
    LabelSpace space;
    EXPECT_NEAR(row(space, {label}), 0, 4);
    space.keep_free(Rect{at.x - 10, at.y - 5, 20, 10});
    EXPECT_NEAR(row(space, {label}), 40, 4);
    space.keep_free(Rect{at.x - 10, at.y + 35, 20, 10});
    EXPECT_NEAR(row(space, {label}), -40, 4);
    space.take({at.x - 10, at.y - 45, 20, 10});
    EXPECT_EQ(row(space, {label}), -1000) << "no place is left";
}

TEST_F(SetType, NamesCoverNeitherVehiclesNorBulbs) {
    auto scene = hand_made::scene();
    scene->sources = {{"left", Channel::light, -3, 0}, {"right", Channel::light, 3, 0}};
    for (const float y : {-1.5f, -1.0f, -0.6f, -0.3f, 0.4f, 0.8f}) {
        Snapshot now = hand_made::empty(scene);
        now.sources = {{0, Channel::light, -3, 0, 1}, {1, Channel::light, 3, 0, 1}};
        hand_made::add(now, 0, -3, y, 0), hand_made::add(now, 0, -2.2f, y, 0);
        DrawList list;
        fill(list, now, picture, Trails{});
        std::vector<LetterInstance> letters;
        set_type(letters, list.labels, lettering, picture, list.label_space);
        EXPECT_GT(letters.size(), 10U);
        for (const LetterInstance& letter : letters)
            for (const Rect& thing : list.label_space.things()) {
                constexpr float halo = Lettering::room;
                const float x = letter.box.x + halo, y0 = letter.box.y + halo;
                const bool apart = x + letter.box.z - 2 * halo <= thing.x || x >= thing.x + thing.w ||
                                   y0 + letter.box.w - 2 * halo <= thing.y || y0 >= thing.y + thing.h;
                EXPECT_TRUE(apart) << y;
            }
    }
}

TEST_F(SetType, OmitsLabelsOutsideTheWindow) {
    EXPECT_TRUE(set({{{500, 0}, 0, {}, "far", {}, 0}}).empty());
    EXPECT_TRUE(set({{{0, -500}, 0, {}, "behind", {}, 0}}).empty());
}

TEST_F(SetType, PlacesALabelWhollyOnItsSide) {
    for (const char* text : {"5 m", "−5", "a long label"}) {
        const auto beside = [&](maths::vec2 away) {
            return around(set({{.place = {2, 3}, .text = text, .away = away}}));
        };
        const maths::vec2 at = *project(picture.camera_view, {2, 3});
        constexpr float halo = Lettering::room + 2;
        EXPECT_LE(beside({-1, 0}).x + beside({-1, 0}).w, at.x + halo) << text;
        EXPECT_GE(beside({1, 0}).x, at.x - halo) << text;
        EXPECT_GE(beside({0, 1}).y, at.y - halo) << text;
        EXPECT_NEAR(beside({-1, 0}).x + beside({-1, 0}).w, at.x, 2 * halo) << text << ": not farther away";
    }
}

TEST_F(SetType, MovesByTheOffsetInLayoutPixels) {
    picture.pixel_scale = 2;
    const Rect plain = around(set({{{0, 0}, 0, {}, "x", {}, 0}})),
               moved = around(set({{{0, 0}, 0, {3, -10}, "x", {}, 0}}));
    EXPECT_NEAR(moved.x - plain.x, 6, 1);
    EXPECT_NEAR(moved.y - plain.y, -20, 1);
}

}  // namespace
}  // namespace braitenlab::tests::set_type_test
