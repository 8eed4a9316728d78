#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "render/view/draw_list.h"
#include "tests/view/drawn.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::draw_shadows_test {
namespace {

using namespace render;
using maths::vec2;

// The shadows of one vehicle at (0, 0) that faces +x, in this theme, at this length on the screen.
std::vector<MarkInstance> shadows(Theme theme, bool large) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0);
    Picture picture;
    picture.theme = theme, picture.quality = Quality::high;
    Camera camera;
    camera.mode = CameraMode::birds_eye, camera.zoom = large ? 3.0f : 0.3f;
    picture.camera_view = look(camera, Arena{}, nullptr, {0, 0, 800, 800}, {0, 0, 800, 800});
    return drawn(now, picture).marks;
}

// The shadow whose centre is nearest to a place.
const MarkInstance& nearest(const std::vector<MarkInstance>& marks, vec2 place) {
    return *std::min_element(marks.begin(), marks.end(), [place](const MarkInstance& a, const MarkInstance& b) {
        const auto far = [place](const MarkInstance& m) { return maths::length(vec2{m.place.x, m.place.y} - place); };
        return far(a) < far(b);
    });
}

TEST(DrawShadows, HasShadowsOfBodyWheelsAndEyesAwayFromTheSunWhereTheyAreLarge) {
    const auto large = shadows(Theme::light, true), small = shadows(Theme::light, false);
    // The body: three; each wheel: two; each eye: one.
    EXPECT_EQ(large.size(), 3U + 4 + 2);
    EXPECT_EQ(small.size(), 3U + 2) << "of the body, and below each wheel";
    for (const MarkInstance& mark : large) EXPECT_EQ(mark.shape.w, static_cast<float>(MarkKind::shadow));
    const vec2 towards = away_from_sun(1);
    const auto along = [&](const MarkInstance& mark) {
        return maths::dot(vec2{mark.place.x, mark.place.y}, towards) / maths::length(towards);
    };
    const auto body = [&](const MarkInstance& mark) { return mark.shape.x > 0.4f; };
    float sum = 0;
    for (const MarkInstance& mark : large)
        if (body(mark)) sum += along(mark);
    EXPECT_NEAR(sum, 1.5f * maths::length(away_from_sun(0.2f)), 1e-4f);
    const vec2 eye{0.30f, -0.24f};  // of the right sensor
    const MarkInstance& of_eye = nearest(large, eye + away_from_sun(0.25f));
    EXPECT_NEAR(of_eye.shape.x, of_eye.shape.y, 1e-6f) << "round";
    EXPECT_GT(maths::dot(vec2{of_eye.place.x, of_eye.place.y} - eye, towards), 0.1f);
}

TEST(DrawShadows, TheSunCastsWeakShadowsAtDusk) {
    const auto day = shadows(Theme::light, true), dusk = shadows(Theme::dark, true);
    const vec2 end = away_from_sun(0.2f);
    const auto share = [&](const std::vector<MarkInstance>& marks, Theme theme) {
        return nearest(marks, end).colour.w / palette(theme).shadow.a;
    };
    EXPECT_LT(share(dusk, Theme::dark), 0.5f * share(day, Theme::light));
}

}  // namespace
}  // namespace braitenlab::tests::draw_shadows_test
