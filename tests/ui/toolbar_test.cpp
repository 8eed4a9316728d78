// The toolbar in windows of several widths.
#include "desk.h"

namespace braitenlab::tests::toolbar_test {

using namespace ui;

namespace {

constexpr const char* buttons[]{"button.open", "button.play",   "button.step",   "button.reset",   "button.new",
                                "button.add",  "button.remove", "button.follow", "button.sensors", "button.outlines",
                                "button.view", "button.wiring", "button.exit"};

// Words within the button, other than its icon.
bool has_words(const Desk& desk, const char* button) {
    const Rect r = desk.where(button);
    for (const Written& w : desk.written) {
        const bool is_icon = !w.words.empty() && static_cast<unsigned char>(w.words[0]) == 0xEF;
        if (!is_icon && r.contains(w.rect.x + w.rect.w / 2, w.rect.y + w.rect.h / 2)) return true;
    }
    return false;
}

}  // namespace

struct ToolbarInEachLanguage : ::testing::TestWithParam<const char*> {};

TEST_P(ToolbarInEachLanguage, HasWordsOnEveryButtonAt1280Pixels) {
    Desk desk(1280, 800, 1, true);
    desk.strings = speaking(GetParam());
    desk.frame(3);
    for (const char* button : buttons) EXPECT_TRUE(has_words(desk, button)) << button;
}

TEST_P(ToolbarInEachLanguage, HasOneRowWithoutOverlapsAtAnyWidth) {
    for (int width = 1024; width <= 1920; width += 64) {
        Desk desk(static_cast<float>(width), 800, 1, true);
        desk.strings = speaking(GetParam());
        desk.view.pace = 0.8f;
        desk.frame(3);
        const std::string pace = fill(desk.strings("time.pace"), {"0.8"});
        const Rect mode = desk.where("mode");
        int paces = 0;
        for (const Written& w : desk.written) {
            if (w.words != pace) continue;
            ++paces;
            EXPECT_GE(w.rect.x, mode.x + mode.w) << width;
        }
        EXPECT_EQ(paces, 1);
        float end = 0;
        for (const char* button : buttons) {
            const Rect r = desk.where(button);
            EXPECT_GE(r.x, end) << button << " at " << width;
            end = r.x + r.w;
        }
        EXPECT_LE(end, static_cast<float>(width)) << width;
        EXPECT_GE(desk.where("mode").x, desk.where("button.faster").x + desk.where("button.faster").w) << width;
    }
}

INSTANTIATE_TEST_SUITE_P(Toolbar, ToolbarInEachLanguage, ::testing::Values("en", "de", "es"),
                         [](const auto& given) { return std::string(given.param); });

TEST(Toolbar, RequestsTheActionOfEachButton) {
    const std::pair<const char*, Action> expected[]{
        {"button.play", Action::play_pause},   {"button.step", Action::step},
        {"button.reset", Action::reset},       {"button.new", Action::new_population},
        {"button.add", Action::add},           {"button.remove", Action::remove},
        {"button.follow", Action::follow},     {"button.sensors", Action::sensors},
        {"button.outlines", Action::outlines}, {"button.wiring", Action::wiring},
        {"button.slower", Action::slower},     {"button.faster", Action::faster},
        {"button.exit", Action::exit}};
    Desk desk(1024, 768);
    desk.frame(3);
    for (const auto& [anchor, action] : expected) {
        desk.all.clear();
        desk.click(anchor);
        EXPECT_EQ(desk.actions(), std::vector{action}) << anchor;
    }
}

}  // namespace braitenlab::tests::toolbar_test
