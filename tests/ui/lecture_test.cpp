// Lecture mode: shown widgets and restored settings.
#include <algorithm>
#include <set>

#include "desk.h"
#include "ui/panels/cards.h"

namespace braitenlab::tests::lecture_test {

using namespace ui;

namespace {

bool shows(const Desk& desk, const std::string& words) {
    for (const Written& w : desk.written)
        if (w.words == words) return true;
    return false;
}

bool overlap(Rect a, Rect b) {
    return a.x < b.x + b.w - 0.5f && b.x < a.x + a.w - 0.5f && a.y < b.y + b.h - 0.5f && b.y < a.y + a.h - 0.5f;
}
bool is_inside(Rect a, Rect b) { return a.x >= b.x && a.y >= b.y && a.x + a.w <= b.x + b.w && a.y + a.h <= b.y + b.h; }

}  // namespace

TEST(Lecture, ClearsTheScreenAndFoldsTheCards) {
    Desk desk;
    desk.open_exercise();
    desk.frame(3);
    desk.view.lecture = true;
    desk.frame(3);
    for (const char* gone : {"card.information", "slider.LL", "exercise.hint", "button.undo", "menu.file"})
        EXPECT_FALSE(desk.anchors.find(gone)) << gone;
    EXPECT_GT(desk.layout.scene.w, 0.9f * desk.layout.window.w);
    EXPECT_TRUE(desk.anchors.find("lecture.left"));
    EXPECT_TRUE(shows(desk, "+0.30")) << "the left wheel's command, large";
}

TEST(Lecture, LeavesTheSpaceOfFoldedCardsToTheScene) {
    Desk desk(1280, 800, 1.4f, true);
    desk.frame(3);
    desk.view.lecture = true;
    desk.frame(4);
    const float width = desk.layout.window.w;
    const Rect left = desk.where("card.scene"), right = desk.where("card.brain");
    EXPECT_LT(left.x + left.w, 0.25f * width);
    EXPECT_GT(right.x, 0.75f * width);
    desk.click("card.brain.fold");
    desk.frame(3);
    EXPECT_GT(desk.where("card.brain").w, right.w) << "an open card takes its space";
    EXPECT_TRUE(desk.anchors.find("slider.LR"));
    EXPECT_LE(desk.layout.scene.x + desk.layout.scene.w, desk.where("card.brain").x) << "and covers nothing of it";
}

TEST(Lecture, AClickOnALampLeavesTheSceneAsItIs) {
    Desk desk(1280, 800, 1.4f, true);
    desk.frame(3);
    desk.view.lecture = true;
    desk.frame(3);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->sources.resize(1);
    desk.now.scene = scene, desk.now.sources.resize(1);
    const Rect before = desk.layout.scene;
    desk.view.settings.selection.object = {SceneObjectKind::source, 0};
    desk.frame(4);
    EXPECT_EQ(desk.layout.scene, before);
    ASSERT_TRUE(desk.anchors.find("card.thing"));
    desk.click("card.thing.fold");
    desk.frame(3);
    EXPECT_LT(desk.layout.scene.w, before.w) << "its card opens on request";
}

TEST(Lecture, SaysThatKeysOfOtherPartsDoNothing) {
    Desk desk;
    desk.open_exercise();
    desk.view.lecture = true;
    desk.frame(3);
    for (const KeyPress press : {KeyPress{'C'}, KeyPress{'H', false, true}, KeyPress{'E'}, KeyPress{key::f10}}) {
        desk.all.clear();
        desk.key(press);
        const auto* notice = desk.last<NoticeRequest>();
        ASSERT_TRUE(notice) << press.key;
        EXPECT_EQ(notice->key, "unavailable.in_lecture");
        EXPECT_FALSE(desk.panels.charts.open);
    }
    desk.panels.card(Card::exercise).folded = false;
    desk.lesson.attempt.answers.hint_ready = true;
    desk.all.clear();
    desk.key({'H', false, true});
    EXPECT_EQ(desk.actions(), std::vector{Action::hint}) << "the card of the exercise shows it";
}

TEST(Lecture, TheOpenBrainLeavesTheButtonsOfTheDiagramFree) {
    Desk desk(1280, 800, 1.4f, true);
    desk.view.mode = Mode::wiring;
    desk.view.lecture = true;
    desk.frame(3);
    for (const bool folded : {true, false}) {
        desk.panels.card(Card::brain).folded = folded;
        desk.frame(4);
        for (const char* button : {"canvas.fit", "canvas.arrange"})
            EXPECT_FALSE(overlap(desk.where(button), desk.where("card.brain"))) << button << ", folded " << folded;
    }
}

TEST(Lecture, KeepsTheTracksOfTheWeightsLongInTheSmallestWindow) {
    Desk desk(1024, 768, 1.375f, true);  // the scale that fits
    desk.now = shipped_scene("2b-aggressor");
    desk.view.lecture = true;
    desk.frame(3);
    desk.panels.card(Card::brain).folded = false;
    desk.frame(20);
    for (const std::string name : {"LL", "LR", "RL", "RR"}) {
        const Rect row = desk.where("slider." + name);
        float track_from = row.x, track_to = row.x + row.w;
        for (const Written& w : desk.written) {
            if (!is_inside(w.rect, row)) continue;
            if (w.words == name)
                track_from = w.rect.x + w.rect.w;
            else
                track_to = w.rect.x;
        }
        EXPECT_GT(track_from, row.x) << name;
        EXPECT_LT(track_to, row.x + row.w) << name << " has a number";
        EXPECT_GT(track_to - track_from, 0.12f * desk.layout.window.w) << name;
    }
}

// A card is not scrolled in a lecture.
TEST(Lecture, ShowsTheSumsOfTheOpenBrainWholeOrNotAtAll) {
    int whole = 0, absent = 0;
    for (float height = 600; height <= 900; height += 20) {
        SCOPED_TRACE(height);
        Desk desk(1280, height, 1.4f, true);
        desk.now = shipped_scene("2b-aggressor");
        desk.view.lecture = true;
        desk.frame(3);
        desk.panels.card(Card::brain).folded = false;
        desk.frame(20);
        const auto sums = std::find_if(desk.shown.begin(), desk.shown.end(),
                                       [](const Shown& each) { return each.id == "equations"; });
        if (sums == desk.shown.end()) {
            ++absent;
            continue;
        }
        ++whole;
        ASSERT_TRUE(desk.anchors.find("equations"));
        EXPECT_NEAR(desk.where("equations").h, sums->rect.h, 1);
        for (const Written& w : desk.written)
            EXPECT_FALSE(w.scrolls && overlap(w.rect, desk.where("card.brain"))) << w.words;
    }
    EXPECT_GT(whole, 2);
    EXPECT_GT(absent, 2);
}

TEST(Lecture, TheOpenBrainIsWholeInTheWindowOfAProjectorAndOfALargeDisplay) {
    struct Size {
        float width, height, scale;
    };
    int sums = 0;
    for (const Size size : {Size{1024, 768, 1.375f}, {1280, 800, 1.4f}, {1920, 1080, 2}, {2560, 1440, 2}})
        for (const char* scene : {"2b-aggressor", "2c", "3b-explorer", "3c-values", "5-logic", "tortoise"})
            for (const std::string& code : shipped_codes())
                for (const bool watching : {false, true}) {
                    SCOPED_TRACE(scene + std::string(" ") + code + " at " + std::to_string(size.width) +
                                 (watching ? ", watching" : ""));
                    Desk desk(size.width, size.height, size.scale, true);
                    desk.strings = speaking(code);
                    desk.now = shipped_scene(scene);
                    desk.view.lecture = true;
                    desk.view.settings.watching = watching;
                    desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
                    desk.frame(3);
                    desk.panels.card(Card::brain).folded = false;
                    desk.frame(20);
                    const Rect card = desk.where("card.brain");
                    EXPECT_LE(card.y + card.h, desk.layout.hint_bar.y);
                    int motors = 0;
                    for (const Written& w : desk.written) {
                        if (!overlap(w.rect, card)) continue;
                        motors += w.words == "ML" || w.words == "MR";
                        EXPECT_FALSE(w.scrolls) << w.words;
                        EXPECT_TRUE(is_inside(w.rect, card)) << w.words;
                    }
                    EXPECT_NE(motors, 1) << "one of two equations";
                    sums += motors == 2;
                }
    EXPECT_GT(sums, 20);
}

TEST(Lecture, ExtendsTheDiagramOverTheCardBelowIt) {
    Desk desk(1280, 800, 1.4f, true);
    desk.view.mode = Mode::wiring;
    desk.frame(3);
    const float open = desk.where("card.inspector").h;
    desk.view.lecture = true;
    desk.frame(3);
    EXPECT_LT(desk.where("card.inspector").h, 0.5f * open);
    EXPECT_GT(desk.where("canvas").w, 0.7f * desk.layout.window.w);
    EXPECT_GT(desk.where("canvas").h, 0.5f * desk.layout.window.h);
    desk.view.lecture = false;
    desk.frame(3);
    EXPECT_FLOAT_EQ(desk.where("card.inspector").h, open);
}

TEST(Lecture, WritesTheNamesOfTheWatchedDiagramLegibly) {
    for (const auto& [width, height] : {std::pair{1280.0f, 800.0f}, std::pair{1024.0f, 768.0f}})
        for (const char* scene : {"tortoise", "7-mnemotrix", "5-logic", "predator-prey"}) {
            SCOPED_TRACE(scene + std::string(" at ") + std::to_string(width));
            Desk desk(width, height, 1.4f, true);
            desk.now = shipped_scene(scene);
            desk.view.lecture = desk.view.settings.watching = true;
            desk.frame(4);
            std::vector<Rect> names;
            for (const Node& node : desk.now.brains[0]->nodes) {
                const Rect name = desk.where("name." + node.name);
                EXPECT_GE(name.h, 17) << node.name;
                EXPECT_GT(name.w, 0) << node.name;
                EXPECT_TRUE(is_inside(name, desk.where("canvas"))) << node.name;
                for (const Rect& other : names) EXPECT_FALSE(overlap(name, other)) << node.name;
                names.push_back(name);
            }
        }
}

TEST(Lecture, NamesTheSideOfEachEyeAndMotorInTheWatchedDiagram) {
    for (const std::string& code : shipped_codes())
        for (const auto& [width, height] : {std::pair{1920.0f, 1080.0f}, std::pair{1024.0f, 768.0f}}) {
            SCOPED_TRACE(code + " at " + std::to_string(width));
            Desk desk(width, height, width > 1500 ? 2.0f : 1.6f, true);
            desk.strings = speaking(code);
            desk.now = shipped_scene("2b-aggressor");
            desk.view.lecture = desk.view.settings.watching = true;
            desk.frame(4);
            std::set<std::string, std::less<>> captions;
            for (const char* key : {"node.SL", "node.SR", "node.ML", "node.MR", "side.left", "side.right"})
                captions.emplace(desk.strings(std::string("wiring.") + key));
            const auto shown = std::count_if(desk.written.begin(), desk.written.end(), [&](const ui::Written& w) {
                return is_inside(w.rect, desk.where("canvas")) && captions.contains(w.words);
            });
            EXPECT_EQ(shown, 4);
        }
}

TEST(Lecture, CoversTheWatchedDiagramWithNoCard) {
    for (const auto& [width, height] :
         {std::pair{1280.0f, 800.0f}, std::pair{1024.0f, 768.0f}, std::pair{800.0f, 1280.0f}})
        for (const bool open : {false, true}) {
            SCOPED_TRACE(std::to_string(width) + (open ? ", open cards" : ", folded cards"));
            Desk desk(width, height, 1.4f, true);
            desk.now = shipped_scene("tortoise");
            desk.view.settings.selection.object = {SceneObjectKind::obstacle, 0};
            desk.view.lecture = desk.view.settings.watching = true;
            desk.frame(3);
            for (const Card card : {Card::brain, Card::object}) desk.panels.card(card).folded = !open;
            desk.frame(4);
            const Rect canvas = desk.where("canvas");
            EXPECT_FALSE(overlap(canvas, desk.where("card.brain")));
            EXPECT_FALSE(overlap(canvas, desk.where("viewport")));
            EXPECT_FALSE(desk.anchors.find("canvas.fit")) << "the buttons would take the diagram's space";
            EXPECT_FALSE(overlap(canvas, desk.where("card.thing")));
            if (open) {
                EXPECT_FALSE(overlap(desk.where("viewport"), desk.where("card.brain")));
            }
        }
}

// The scene is the subject: cards scroll or are one below the other.
TEST(Lecture, OpenCardsLeaveTheSceneHalfOfTheFreeWidthOrBesideADiagramOfTheHeight) {
    struct Size {
        float width, height, scale;
    };
    const insight::Design stored{};
    for (const Size size : {Size{800, 600, 1}, {1024, 768, 1.4f}, {1280, 800, 1.4f}, {1920, 1080, 1.75f}})
        for (const std::string& code : shipped_codes())
            for (const bool watching : {false, true})
                for (const Card left : {Card::scene, Card::slots}) {
                    SCOPED_TRACE(code + " at " + std::to_string(size.width) + (watching ? ", watching" : "") +
                                 (left == Card::slots ? ", two brains" : ""));
                    Desk desk(size.width, size.height, size.scale, true);
                    desk.strings = speaking(code);
                    desk.now = shipped_scene("2b-aggressor");
                    desk.view.lecture = true;
                    desk.view.settings.watching = watching;
                    desk.frame(3);
                    if (left == Card::slots)
                        for (SlotView& slot : desk.view.features.slots.slots) slot = {.design = &stored, .kind = "one"};
                    for (const Card open : {Card::brain, left}) desk.panels.card(open).folded = false;
                    desk.frame(6);
                    const Rect scene = desk.where("viewport"), window = desk.layout.window;
                    if (watching) {
                        EXPECT_GE(scene.h, 0.5f * (window.h - desk.layout.toolbar.h) - 60 * size.scale);
                    } else {
                        EXPECT_GE(scene.w, 0.47f * window.w);
                        EXPECT_TRUE(desk.anchors.find(left == Card::slots ? "card.slots" : "card.scene"));
                        EXPECT_TRUE(desk.anchors.find("slider.LL"));
                    }
                    for (const char* card : {"card.brain", "card.scene", "card.slots"}) {
                        if (!desk.anchors.find(card)) continue;
                        if (desk.where(card).h > 60 * size.scale) {
                            EXPECT_FALSE(overlap(scene, desk.where(card))) << card;
                        }
                        EXPECT_LE(desk.where(card).y + desk.where(card).h, window.h) << card;
                    }
                }
}

TEST(Lecture, FitsTheDiagramToItsPlaceAlsoAfterASmallMove) {
    Desk desk(1280, 800, 1.4f, true);
    desk.now = shipped_scene("2b-aggressor");
    desk.view.lecture = desk.view.settings.watching = true;
    desk.view.settings.canvas_share = 0.55f;
    desk.frame(4);
    const Rect before = desk.where("canvas");
    desk.view.settings.canvas_share = 0.6f;
    desk.frame(2);
    const Rect canvas = desk.where("canvas"), left = desk.where("node.SL"), right = desk.where("node.MR");
    ASSERT_GT(before.x - canvas.x, 20);
    ASSERT_LT(canvas.w - before.w, 0.2f * canvas.w) << "outside a lecture this is no reason to fit it again";
    EXPECT_NEAR((left.x + right.x + right.w) / 2, canvas.x + canvas.w / 2, 5);
}

TEST(Lecture, ShowsNoHintOfABeginnerAndNoTooltip) {
    Desk desk(1280, 800, 1.4f, true);
    desk.open_exercise();
    desk.view.lecture = true;
    desk.panels.card(Card::brain).folded = false;
    desk.frame(4);
    const auto shows_tooltip = [&] {
        desk.point("button.play");
        desk.frame(90);
        return shows(desk, std::string(desk.strings("tooltip.play_pause")));
    };
    EXPECT_FALSE(shows_tooltip());
    desk.view.lecture = false;
    desk.frame(3);
    EXPECT_TRUE(shows_tooltip());
}

TEST(Lecture, SaysThatAnEarlierMomentIsShownAndHowEarly) {
    Desk desk(1024, 768, 1.4f, true);
    desk.view.lecture = true;
    desk.now.tick = 300, desk.now.seconds = 5, desk.view.timeline.latest = 300;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("lecture.past"));
    desk.view.timeline.latest = 990;
    desk.frame(2);
    ASSERT_TRUE(desk.anchors.find("lecture.past"));
    EXPECT_TRUE(shows(desk, "PAST: −11.5 s"));
    EXPECT_TRUE(shows(desk, "5.0 s"));
    desk.strings = speaking("de");
    desk.frame(2);
    EXPECT_TRUE(shows(desk, "VERGANGENHEIT: −11,5 s"));
    EXPECT_LT(desk.where("lecture.past").x + desk.where("lecture.past").w, desk.where("lecture.leave").x);
}

TEST(Lecture, TellsNoOutcomeBeforeThePrediction) {
    Desk desk(1280, 800, 1, true);
    desk.open_exercise();
    desk.view.lecture = true;
    desk.frame(3);
    const auto writes = [&](std::string_view words) {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& written) { return written.words == words; });
    };
    const std::string_view title = desk.opened.title, character = "?";
    EXPECT_FALSE(writes(title));
    EXPECT_TRUE(writes(character));
    desk.lesson.attempt.answers.prediction = 0;
    desk.lesson.attempt.work.has_run = true;
    desk.frame(3);
    EXPECT_TRUE(writes(title));
    EXPECT_FALSE(writes(character));
}

TEST(Lecture, RestoresEveryCard) {
    Desk desk;
    desk.open_exercise();
    desk.panels.card(Card::brain).folded = true;
    desk.frame(3);
    desk.panels.keyboard.focus = "exercise.hint";
    desk.frame(2);
    const auto before = desk.anchors.all();
    desk.view.lecture = true;
    desk.frame(3);
    desk.click("card.exercise.fold");
    desk.key({'2'});
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("slider.LR")) << "cards can be opened in a lecture";
    desk.view.lecture = false;
    desk.frame(4);
    EXPECT_TRUE(desk.panels.card(Card::brain).folded);
    EXPECT_FALSE(desk.panels.card(Card::exercise).folded);
    EXPECT_EQ(desk.panels.keyboard.focus, "exercise.hint");
    EXPECT_EQ(desk.anchors.all().size(), before.size());
    for (const auto& [id, rect] : before) {
        const Rect* now = desk.anchors.find(id);
        ASSERT_TRUE(now) << id;
        EXPECT_FLOAT_EQ(now->x, rect.x) << id;
        EXPECT_FLOAT_EQ(now->y, rect.y) << id;
        EXPECT_FLOAT_EQ(now->h, rect.h) << id;
    }
}

TEST(Lecture, ShowsPressedKeysForSomeSeconds) {
    Desk desk;
    desk.frame(2);
    desk.key({'S'});
    desk.frame(2);
    EXPECT_FALSE(shows(desk, "S")) << "pressed keys are shown only in a lecture";
    desk.view.lecture = true;
    desk.frame(2);
    desk.key({' '});
    desk.key({'Z', true});
    desk.frame(2);
    EXPECT_TRUE(shows(desk, "Space"));
    EXPECT_TRUE(shows(desk, "Ctrl+Z"));
    desk.view.wall_seconds += 3;
    desk.frame(2);
    EXPECT_FALSE(shows(desk, "Space"));
}

TEST(Lecture, CountsPredatorsAndPrey) {
    Desk desk;
    desk.view.lecture = true;
    desk.frame(3);
    EXPECT_TRUE(shows(desk, "4"));
    EXPECT_TRUE(shows(desk, "8"));
}

TEST(Lecture, RestoresTheFoldOfEachCardOfTheTable) {
    for (const bool folded : {false, true}) {
        Desk desk;
        for (const CardTraits& row : cards()) desk.panels.card(row.card).folded = folded;
        desk.view.lecture = true;
        follow_lecture(desk.view, desk.panels);
        for (const CardTraits& row : cards()) {
            CardState& card = desk.panels.card(row.card);
            EXPECT_TRUE(card.folded || row.in_lecture != InLecture::folded) << row.anchor;
            if (row.in_lecture != InLecture::unchanged) card.folded = !folded;
        }
        desk.view.lecture = false;
        follow_lecture(desk.view, desk.panels);
        for (const CardTraits& row : cards()) EXPECT_EQ(desk.panels.card(row.card).folded, folded) << row.anchor;
    }
}

}  // namespace braitenlab::tests::lecture_test
