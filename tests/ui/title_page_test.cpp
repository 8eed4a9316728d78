// The title page of the first start.
#include "ui/panels/title_page.h"

#include "desk.h"

namespace braitenlab::tests::title_page_test {

namespace {

bool begins(const Desk& desk) { return desk.last<BeginRequest>() != nullptr; }

}  // namespace

TEST(TitlePage, ShowsTheNameASentenceAndOneButtonAndNothingElse) {
    for (const std::string& code : shipped_codes())
        for (const auto& [width, height, scale] :
             {std::tuple{640.0f, 480.0f, 1.0f}, {1024.0f, 768.0f, 1.0f}, {2560.0f, 1600.0f, 2.0f}}) {
            SCOPED_TRACE(code + " " + std::to_string(width));
            Desk desk(width, height, scale, true);
            desk.strings = speaking(code);
            desk.view.program.title_page = true;
            desk.frame(2);
            ASSERT_EQ(desk.shown.size(), 1u);
            EXPECT_EQ(desk.shown[0].id, "title.begin");
            for (const ui::Written& w : desk.written) {
                EXPECT_GE(w.rect.x, 0) << w.words;
                EXPECT_LE(w.rect.x + w.rect.w, width - 20 * scale) << w.words;
                EXPECT_GE(w.rect.y, 0) << w.words;
                EXPECT_LE(w.rect.y + w.rect.h, height) << w.words;
            }
            EXPECT_EQ(desk.written.front().words, "Braitenlab");
        }
}

TEST(TitlePage, ItsWordsAreAboveTheSceneOfAnUprightWindow) {
    for (const auto& [width, height] : {std::pair{512.0f, 1024.0f}, {640.0f, 1280.0f}, {768.0f, 1024.0f}}) {
        Desk desk(width, height, 1, true);
        desk.view.program.title_page = true;
        desk.frame(2);
        const Rect button = desk.where("title.begin");
        EXPECT_LT(button.y + button.h, ui::title_words_share * height) << width;
    }
}

TEST(TitlePage, ItsButtonIsHighEnoughForAFingerAlsoWhereThePageIsReduced) {
    constexpr float finger = 44;
    struct Page {
        float width, height, density, scale;
    };
    // 400 × 800 and 800 × 400 pixels of a telephone with one or two pixels of its display each, and a tablet.
    for (const Page& page : {Page{640, 1280, 1.6f, 1}, {1280, 2560, 3.2f, 1}, {960, 480, 1.2f, 1}, {1024, 768, 1, 1}})
        for (const std::string& code : shipped_codes()) {
            SCOPED_TRACE(code + " " + std::to_string(page.width));
            Desk desk(page.width, page.height, page.scale, true);
            desk.strings = speaking(code);
            desk.view.program.title_page = true;
            desk.view.program.finger = finger * page.density;
            desk.frame(2);
            const Rect button = desk.where("title.begin");
            EXPECT_GE(button.h, finger * page.density);
            EXPECT_GE(button.x, 0);
            EXPECT_LE(button.x + button.w, page.width);
            for (const ui::Written& each : desk.written) {
                const bool is_inside = button.contains(each.rect.x, each.rect.y);
                const bool is_apart = each.rect.y + each.rect.h <= button.y || each.rect.y >= button.y + button.h;
                EXPECT_TRUE(is_inside || is_apart) << each.words;
            }
        }
    Desk unknown(1024, 768, 1, true);
    unknown.view.program.title_page = true;
    unknown.frame(2);
    EXPECT_GE(unknown.where("title.begin").h, finger) << "before a finger has touched the window";
}

TEST(TitlePage, BeginsByItsButtonEnterSpaceAndEscape) {
    for (const int key : {key::enter, static_cast<int>(' '), key::escape}) {
        Desk desk;
        desk.view.program.title_page = true;
        desk.frame(2);
        desk.key({key});
        EXPECT_TRUE(begins(desk)) << key;
        EXPECT_TRUE(desk.actions().empty()) << key;
    }
    Desk desk;
    desk.view.program.title_page = true;
    desk.frame(2);
    desk.click("title.begin");
    EXPECT_TRUE(begins(desk));
}

TEST(TitlePage, OnlyKeysOfTheWindowWorkOnIt) {
    Desk desk;
    desk.view.program.title_page = true;
    desk.frame(2);
    for (const KeyPress press : {KeyPress{'R'}, {'W'}, {key::f1}, {'A'}}) desk.key(press);
    desk.frame(2);
    EXPECT_TRUE(desk.all.empty());
    EXPECT_EQ(desk.panels.sheet, ui::Sheet::none);
    desk.key({key::f11});
    desk.key({'Q', true});
    EXPECT_EQ(desk.actions(), (std::vector{Action::full_screen, Action::exit}));
}

TEST(TitlePage, KeysOfALecturerBeginAndDoTheirOwn) {
    Desk desk;
    desk.view.program.title_page = true;
    desk.frame(2);
    desk.key({key::f9});
    EXPECT_TRUE(begins(desk));
    EXPECT_EQ(desk.actions(), std::vector{Action::lecture});
    desk.all.clear();
    desk.key({'O', true});
    EXPECT_TRUE(begins(desk));
    EXPECT_EQ(desk.panels.sheet, ui::Sheet::files);
}

}  // namespace braitenlab::tests::title_page_test
