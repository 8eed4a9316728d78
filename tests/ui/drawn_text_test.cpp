// The size of texts and what cuts them; and a matrix of windows in which no text is cut, no widget overlaps another one
// and no target is too small.
#include "ui/widgets/drawn_text.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "desk.h"
#include "large_brain.h"

namespace braitenlab::tests::drawn_text_test {

using namespace ui;

namespace {

Written text_at(float x, float y, bool scrolls = false) {
    return {"words", {x, y, 40, 22}, {100, 100, 200, 200}, nullptr, 16, scrolls};
}

// One window of the matrix.
struct Window {
    float width, height, scale;
    std::string language;
    Theme theme;
    bool lecture;
};

std::string name(const Window& w) {
    return std::to_string(static_cast<int>(w.width)) + "x" + std::to_string(static_cast<int>(w.height)) + " at " +
           std::to_string(w.scale) + " " + w.language + (w.theme == Theme::light ? " light" : " dark") +
           (w.lecture ? " lecture" : "");
}

constexpr float sizes[][2]{{1024, 768}, {1280, 800}, {1920, 1080}, {2560, 1440}, {3840, 2160}};
constexpr float scales[]{0.75f, 1, 1.5f, 2, 3};

// Each pair of a size and a scale; language, theme and lecture take turns so that each pair of two values occurs.
std::vector<Window> windows() {
    std::vector<Window> all;
    for (int s = 0; s < 5; ++s)
        for (int k = 0; k < 5; ++k) {
            const std::string& language = shipped_codes()[static_cast<std::size_t>(s + k) % shipped_codes().size()];
            const int theme = (s + k / 2) % 2, lecture = (s / 2 + k) % 2;
            all.push_back(
                {sizes[s][0], sizes[s][1], scales[k], language, theme ? Theme::light : Theme::dark, lecture == 1});
        }
    return all;
}

// The scale that the window takes; type is larger in a lecture.
float scale_of(const Window& w) {
    constexpr float lecture_type = 1.4f;  // as in app/course/lab_lecture.h
    const float wanted = w.lecture ? lecture_type * std::max(w.scale, w.height / 800) : w.scale;
    return fitting_scale(wanted, {0, 0, w.width, w.height}, w.lecture);
}

struct Scene {
    const char* name;
    std::function<void(Desk&)> set;
};

void open_every_card(Desk& desk) {
    for (const Card card : {Card::scene, Card::sensors, Card::brain, Card::information, Card::exercise})
        desk.panels.card(card).folded = false, desk.panels.card(card).opened_by_user = true;
}

const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all{
        {"exercise",
         [](Desk& d) {
             d.open_exercise();
             d.lesson.attempt.answers.prediction = 1, d.lesson.attempt.work.has_run = true,
             d.lesson.attempt.answers.hints_shown = 3;
         }},
        {"hidden neurons",
         [](Desk& d) {
             d.now = snapshot(0);
             d.now.brains[0] = std::make_shared<BrainGraph>(large_brain(7, 12));
             d.now.vehicles[0].neuron_count = 5;
             d.now.neurons = {-0.31f, -0.52f, -0.83f, -1, 0.25f};
             d.panels.card(Card::brain).folded = false;
         }},
        {"wiring",
         [](Desk& d) {
             d.now = snapshot(0);
             d.now.brains[0] = std::make_shared<BrainGraph>(large_brain(7, 12));
             d.now.vehicles[0].neuron_count = 5;
             d.now.neurons = {-0.31f, -0.52f, -0.83f, -1, 0.25f};
             d.view.mode = Mode::wiring;
         }},
        {"predators and prey, all cards open",
         [](Desk& d) {
             d.now = shipped_scene("predator-prey");
             d.view.settings.selection.vehicle = d.now.vehicles.front().id;
             open_every_card(d);
         }},
        {"negative numbers",
         [](Desk& d) {
             d.now = snapshot(0);
             d.now.brains[0] =
                 std::make_shared<BrainGraph>(make_graph({-1.25f, -0.75f, -2, -1.5f, 0.1f, 0.2f, 0.3f, 1, -0.5f, -1}));
             d.now.vehicles[0].motor = {-0.83f, -1};
             d.panels.card(Card::brain).folded = false;
         }},
    };
    return all;
}

void show(Desk& desk, const Window& w, const Scene& scene) {
    desk.strings = speaking(w.language);
    desk.view.program.theme = w.theme;
    scene.set(desk);
    const bool folded = desk.panels.card(Card::brain).folded;
    desk.view.lecture = w.lecture;
    desk.frame(3);
    desk.panels.card(Card::brain).folded = folded;
    desk.frame(4);
}

// A heading folds its card, and its buttons are on it; the signs at the ends of wires are near each other, and the
// nearest is taken.
bool may_overlap(const std::string& id) { return id.ends_with(".fold") || id.starts_with("lesion."); }

void expect_no_overlap(const Desk& desk) {
    std::vector<std::pair<std::string, Rect>> targets;
    for (const Shown& each : desk.shown) {
        const Rect* visible = desk.anchors.find(each.id);
        if (each.enabled && visible && !may_overlap(each.id)) targets.emplace_back(each.id, *visible);
    }
    EXPECT_GT(targets.size(), 3u);
    for (std::size_t i = 0; i < targets.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const auto& [a, r] = targets[i];
            const auto& [b, s] = targets[j];
            const float across = std::min(r.x + r.w, s.x + s.w) - std::max(r.x, s.x);
            const float down = std::min(r.y + r.h, s.y + s.h) - std::max(r.y, s.y);
            EXPECT_FALSE(a != b && across > 1 && down > 1) << a << " overlaps " << b;
        }
}

void expect_large_targets(const Desk& desk, float scale) {
    constexpr float least = 24;  // layout pixels
    for (const Shown& each : desk.shown)
        if (each.enabled) {
            EXPECT_GT(std::min(each.rect.w, each.rect.h), least * scale - 0.5f) << each.id;
        }
}

void expect_whole_text(const Desk& desk, float scale) {
    constexpr float least = 12;  // layout pixels
    for (const Written& w : desk.written)
        EXPECT_FALSE(is_cut(w)) << w.words << " at " << w.rect.x << ", " << w.rect.y << " in " << w.clip.x << ", "
                                << w.clip.y << ", " << w.clip.w << ", " << w.clip.h;
    std::string ends;  // the texts that end with an ellipsis, for the message
    for (const Written& w : desk.written)
        if (w.words.ends_with("…")) ends += " '" + w.words + "'";
    EXPECT_EQ(desk.shortened, 0) << "an ellipsis replaces a part of a text:" << ends;
    if (desk.view.mode == Mode::wiring) return;  // the diagram of a large brain is made smaller
    const TextFacts facts = text_facts(desk.written, desk.shortened);
    EXPECT_GE(facts.smallest, least * scale - 0.5f);
}

}  // namespace

TEST(DrawnText, IsCutWhereItsClipRectangleEndsButNotWhereItScrolls) {
    EXPECT_FALSE(is_cut(text_at(120, 120)));
    EXPECT_TRUE(is_cut(text_at(90, 120)));
    EXPECT_TRUE(is_cut(text_at(290, 120)));
    EXPECT_TRUE(is_cut(text_at(120, 288)));
    EXPECT_FALSE(is_cut(text_at(120, 288, true)));
    EXPECT_FALSE(is_cut(text_at(120, 400))) << "it is not visible";
    EXPECT_FALSE(is_cut(text_at(120, 98))) << "the spacing above the letters";
}

TEST(DrawnText, TellsTheSmallestTextAndTheNumberOfCutOnes) {
    std::vector<Written> all{text_at(120, 120), text_at(90, 120), text_at(120, 400)};
    all[0].size = 14, all[2].size = 8;
    const TextFacts facts = text_facts(all, 2);
    EXPECT_EQ(facts.smallest, 14) << "the text that is not visible does not count";
    EXPECT_EQ(facts.clipped, 3);
    EXPECT_EQ(text_facts({}, 0).smallest, 0);
}

TEST(DrawnText, CountsTextsThatWereShortened) {
    Desk desk(1280, 800, 1, true);
    desk.now.vehicles[0].start = -1;
    desk.frame(3);
    EXPECT_EQ(desk.shortened, 0);
    desk.view.notice = {NoticeKind::failure, std::string(400, 'W')};
    desk.frame(2);
    EXPECT_GE(desk.shortened, 1);
}

TEST(DrawnText, FitsTogetherWithWidgetsInEachWindow) {
    for (const Window& w : windows())
        for (const Scene& scene : scenes()) {
            SCOPED_TRACE(name(w) + ", " + scene.name);
            const float scale = scale_of(w);
            Desk desk(w.width, w.height, scale, true);
            show(desk, w, scene);
            expect_whole_text(desk, scale);
            expect_no_overlap(desk);
            expect_large_targets(desk, scale);
            if (desk.view.mode != Mode::wiring) {
                EXPECT_GE(desk.layout.scene.w, 0.25f * w.width);
            }
        }
}

// At the default size without scrolling.
TEST(DrawnText, ShowsTheWholeBrainCardOfAPredator) {
    for (const std::string& language : shipped_codes())
        for (const auto& [width, height] : {std::pair{1280.0f, 800.0f}, std::pair{1024.0f, 768.0f}}) {
            SCOPED_TRACE(language + " " + std::to_string(width));
            Desk desk(width, height, 1, true);
            desk.strings = speaking(language);
            desk.now = shipped_scene("predator-prey");
            desk.rest();
            constexpr float heading_and_padding = 48;
            EXPECT_LE(desk.panels.card(Card::brain).content + heading_and_padding, desk.where("card.brain").h + 1);
        }
}

}  // namespace braitenlab::tests::drawn_text_test
