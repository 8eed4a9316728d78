// The table of keys: a key that it does not list has no effect, and F1 shows the whole table.
#include <algorithm>
#include <set>

#include "lecture_on_desk.h"

namespace braitenlab::tests::keys_card_test {

using namespace ui;

namespace {

std::vector<KeyPress> all_presses() {
    std::vector<KeyPress> all;
    const auto add = [&](int key) {
        for (const bool ctrl : {false, true})
            for (const bool shift : {false, true}) all.push_back({key, ctrl, shift});
    };
    for (int printable = ' '; printable <= 'Z'; ++printable) add(printable);
    for (int named = key::escape; named < key::f1 + 25; ++named) add(named);
    return all;
}

bool ring_round(const Desk& desk, std::string_view id) {
    return desk.panels.keyboard.focus == id && desk.panels.keyboard.shown;
}

struct Where {
    const char* name;
    KeyPlace place;
    void (*go)(Desk&);
};
constexpr Where everywhere[]{
    {"everywhere", KeyPlace::everywhere, [](Desk&) {}},
    {"in a widget", KeyPlace::widget, [](Desk& desk) { desk.panels.keyboard.focus = "slider.LL"; }},
    {"in the canvas", KeyPlace::canvas, [](Desk& desk) { desk.view.mode = Mode::wiring; }}};

}  // namespace

TEST(KeysCard, ListsMouseActionsAndAllFourArrowKeys) {
    Desk desk(1280, 2400, 1, true);
    desk.key({key::f1});
    desk.frame(3);
    std::string all;
    for (const Written& w : desk.written) all += w.words + " ";  // the lines of one text follow one another
    EXPECT_NE(all.find(std::string(desk.strings("mouse_does.wheel"))), std::string::npos);
    EXPECT_NE(all.find(std::string(desk.strings("mouse_does.drag"))), std::string::npos);
    EXPECT_NE(all.find("\uf060 \uf061 \uf062 \uf063"), std::string::npos)
        << "arrow keys are icons, as large as other keys";
    EXPECT_EQ(all.find("←"), std::string::npos);
}

TEST(KeysCard, BeginsInAnExerciseWithTheKeysOfAnswersAndSliders) {
    Desk desk(1280, 2400, 1, true);
    const auto top = [&](std::string_view key) {
        float y = -1;
        for (const Written& w : desk.written)
            if (w.words.size() > 8 && desk.strings(key).starts_with(w.words)) y = w.rect.y;  // or its first line
        return y;
    };
    desk.key({key::f1});
    desk.frame(3);
    EXPECT_GT(top("keys.place.answer"), top("keys.place.everywhere"));
    desk.open_exercise();
    desk.frame(3);
    EXPECT_LT(top("keys.place.answer"), top("keys.place.widget"));
    EXPECT_LT(top("keys.place.widget"), top("keys.place.everywhere"));
}

TEST(KeysCard, BeginsWithPlayingOutsideALecture) {
    for (const std::string& language : shipped_codes()) {
        Desk desk(1280, 2400, 1, true);
        desk.strings = speaking(language);
        desk.key({key::f1});
        for (const bool in_exercise : {false, true}) {
            if (in_exercise) desk.open_exercise();
            desk.frame(3);
            const auto begin = std::find_if(desk.written.begin(), desk.written.end(), [&](const Written& w) {
                return w.words == desk.strings("keys.place.playing");
            });
            ASSERT_NE(begin, desk.written.end()) << language;
            for (const char* other : {"keys.place.everywhere", "keys.place.answer"})
                for (const Written& w : desk.written)
                    if (w.words == desk.strings(other)) {
                        EXPECT_LT(begin->rect.y, w.rect.y) << language << " " << other;
                    }
        }
    }
}

TEST(KeysCard, BeginsInALectureWithItsKeysAndOmitsThoseThatTheyReplace) {
    Desk desk(1280, 2400, 1, true);
    const auto row_of = [&](std::string_view key) -> const Written* {
        for (const Written& w : desk.written)
            if (w.words.size() > 5 && desk.strings(key).starts_with(w.words)) return &w;
        return nullptr;
    };
    desk.key({key::f1});
    desk.frame(3);
    EXPECT_TRUE(row_of("action.new_population"));
    desk.view.lecture = true;
    desk.frame(3);
    EXPECT_TRUE(row_of("action.draw_marks"));
    EXPECT_FALSE(row_of("action.notes")) << "there are no pages";
    const LectureView pages = opened_lecture("four-numbers");
    desk.view.pages = &pages;
    desk.frame(3);
    ASSERT_TRUE(row_of("keys.place.lecture") && row_of("keys.place.everywhere"));
    EXPECT_LT(row_of("keys.place.lecture")->rect.y, row_of("keys.place.everywhere")->rect.y);
    EXPECT_TRUE(row_of("action.notes"));
    EXPECT_FALSE(row_of("action.new_population")) << "N shows the notes";
}

TEST(KeysCard, KeepsWordsAndKeysApartInEveryLanguage) {
    for (const std::string& code : shipped_codes()) {
        Desk desk(1280, 2400, 1, true);
        desk.strings = speaking(code);
        desk.key({key::f1});
        desk.frame(3);
        const void* sheet = nullptr;
        for (const Written& w : desk.written)
            if (w.words == desk.strings("mouse.wheel")) sheet = w.sheet;
        int pairs = 0;
        for (const Written& a : desk.written)
            for (const Written& b : desk.written) {
                if (a.sheet != sheet || b.sheet != sheet || a.rect.y != b.rect.y || a.rect.x >= b.rect.x) continue;
                ++pairs;
                EXPECT_GE(b.rect.x - (a.rect.x + a.rect.w), 8) << code << ": " << a.words << " | " << b.words;
            }
        EXPECT_GT(pairs, 60);
    }
}

TEST(KeysCard, TheKeysOfAColumnBeginAtTheSamePlace) {
    Desk desk(1280, 2400, 1, true);
    desk.key({key::f1});
    desk.frame(3);
    std::set<float> beginnings;
    int keys = 0;
    for (const Written& w : desk.written)
        if (w.words == "R" || w.words == "W" || w.words == "N" || w.words == "Ctrl+Z" || w.words == "Ctrl+S")
            beginnings.insert(w.rect.x), ++keys;
    EXPECT_GE(keys, 5);
    EXPECT_LE(beginnings.size(), 3u) << "one place in each of the three columns";
}

TEST(KeysCard, ListsEveryKeyThatHasAnEffect) {
    for (const Where& where : everywhere) {
        int used = 0;
        Desk desk;
        for (const KeyPress press : all_presses()) {
            desk.panels = PanelState{};
            where.go(desk);
            const bool listed = action_for(press, where.place) || action_for(press);
            Outbox asked;
            const bool taken = press_key(desk.view, desk.panels, press, asked);
            used += taken;
            if (press.key == key::del && where.place == KeyPlace::canvas) continue;  // no selection to delete
            EXPECT_EQ(taken, listed) << key_name(press, desk.strings) << " " << where.name;
        }
        EXPECT_GT(used, 30);
    }
}

TEST(KeysCard, ShowsAllKeysOnF1) {
    Desk desk(1280, 1400);
    desk.frame(2);
    desk.key({key::f1});
    desk.frame(3);
    std::set<std::string> words;
    std::string all;  // a sentence may take several lines, one after the other
    for (const Written& w : desk.written) words.insert(w.words), all += w.words + " ";
    std::set<std::pair<KeyPlace, Action>> seen;
    for (const Shortcut& shortcut : shortcuts()) {
        if (!seen.insert({shortcut.place, shortcut.action}).second) continue;  // further keys of the same action
        EXPECT_TRUE(words.count(key_name(shortcut.press, desk.strings))) << key_name(shortcut.press, desk.strings);
        const std::string_view sentence = desk.strings("action." + std::string(name(shortcut.action)));
        EXPECT_NE(all.find(std::string(sentence) + " "), std::string::npos) << name(shortcut.action);
    }
}

TEST(Keyboard, ShowsTheFocusRingOnlyAfterAKeyPress) {
    Desk desk;
    desk.frame(3);
    desk.key({'2'});
    desk.frame(2);
    EXPECT_TRUE(ring_round(desk, "slider.LR"));
    desk.key({' '});
    desk.frame(2);
    EXPECT_FALSE(ring_round(desk, "slider.LR")) << "the run plays now: no focus ring";
    desk.key({key::right});
    desk.frame(2);
    EXPECT_TRUE(ring_round(desk, "slider.LR"));
    desk.click("button.step");
    EXPECT_FALSE(desk.panels.keyboard.shown);
    desk.key({key::tab});
    desk.frame(2);
    EXPECT_TRUE(desk.panels.keyboard.shown);
}

TEST(KeysCard, ScrollsByKeysInALowWindow) {
    Desk desk(1024, 480, 1, true);
    desk.key({key::f1});
    desk.frame(4);
    const auto top = [&] {
        float y = 1e9f;
        for (const Written& written : desk.written)
            if (written.words == desk.strings("action.play_pause")) y = std::min(y, written.rect.y);
        return y;
    };
    const auto press = [&](int key) {
        desk.key({key});
        desk.frame(3);
        return top();
    };
    const float first = top(), line = press(key::down), page = press(key::page_down), last = press(key::end);
    EXPECT_LT(line, first);
    EXPECT_LT(page, line - 100);
    EXPECT_LE(last, page);
    EXPECT_GT(press(key::up), last);
    EXPECT_FLOAT_EQ(press(key::home), first);
}

}  // namespace braitenlab::tests::keys_card_test
