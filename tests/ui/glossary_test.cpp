#include "ui/panels/course/glossary.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "desk.h"

namespace braitenlab::tests::glossary_test {

using namespace ui;

namespace {

std::string text_of_term(const Strings& strings, std::string_view id, const char* what) {
    return std::string(strings.find("glossary." + std::string(id) + "." + what, ""));
}

std::size_t words_in(const std::string& text) {
    std::istringstream in(text);
    return static_cast<std::size_t>(std::distance(std::istream_iterator<std::string>(in), {}));
}

// What the open sheet draws of a picture at a time: positions of the vertices inside and around its frame.
struct Vertices {
    std::vector<std::pair<float, float>> all;
    Rect bounds{1e9f, 1e9f, 0, 0};
};

// Draws the picture of a term alone, in a window of its own.
Vertices picture(const GlossaryTerm& term, double seconds, Rect frame) {
    Desk desk;
    const Ui ui{desk.strings, palette(Theme::dark), {}, 1, desk.anchors, desk.asked};
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({600, 600});
    ImGui::Begin("picture", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const int before = list.VtxBuffer.Size;
    term.draw(ui, frame, seconds);
    Vertices drawn;
    float right = -1e9f, bottom = -1e9f;
    for (int i = before; i < list.VtxBuffer.Size; ++i) {
        const ImVec2 p = list.VtxBuffer[i].pos;
        drawn.all.emplace_back(p.x, p.y);
        drawn.bounds.x = std::min(drawn.bounds.x, p.x), drawn.bounds.y = std::min(drawn.bounds.y, p.y);
        right = std::max(right, p.x), bottom = std::max(bottom, p.y);
    }
    drawn.bounds.w = right - drawn.bounds.x, drawn.bounds.h = bottom - drawn.bounds.y;
    ImGui::End();
    ImGui::Render();
    return drawn;
}

void open_with_goal(Desk& desk, const std::string& goal) {
    desk.open_exercise();
    desk.opened.goal = goal;
    desk.frame(3);
}

TEST(Glossary, EveryTermHasANameAndOneShortSentenceAndFormsInEachLanguage) {
    ASSERT_GE(terms().size(), 20u);
    for (const std::string& code : shipped_codes()) {
        const Strings strings = speaking(code);
        std::set<std::string> forms;
        for (const GlossaryTerm& term : terms()) {
            const std::string what = code + " " + std::string(term.id);
            EXPECT_FALSE(text_of_term(strings, term.id, "name").empty()) << what;
            const std::string text = text_of_term(strings, term.id, "text");
            EXPECT_GE(words_in(text), 5u) << what;
            EXPECT_LE(words_in(text), 25u) << what;
            EXPECT_TRUE(text.ends_with(".")) << what;
            std::istringstream all(text_of_term(strings, term.id, "forms"));
            int count = 0;
            for (std::string form; std::getline(all, form, ','); ++count)
                EXPECT_TRUE(forms.insert(form).second) << what << ": " << form << " belongs to two terms";
            EXPECT_GT(count, 0) << what;
        }
    }
}

TEST(Glossary, EveryPictureMovesAndStaysWithinItsFrame) {
    const Rect frame{100, 80, 236, 142};
    for (const GlossaryTerm& term : terms()) {
        std::set<std::vector<std::pair<float, float>>> seen;
        for (int i = 0; i < 24; ++i) {
            const Vertices drawn = picture(term, 0.37 * i, frame);
            ASSERT_FALSE(drawn.all.empty()) << term.id;
            seen.insert(drawn.all);
            const Rect& b = drawn.bounds;
            EXPECT_TRUE(b.x >= frame.x - 1 && b.y >= frame.y - 1 && b.x + b.w <= frame.x + frame.w + 1 &&
                        b.y + b.h <= frame.y + frame.h + 1)
                << term.id << " at " << 0.37 * i << " s: " << b.x << " " << b.y << " " << b.w << " " << b.h;
        }
        EXPECT_GT(seen.size(), 2u) << term.id << " does not move";
    }
}

TEST(Glossary, EveryTermIsOneClickFromItsWordInEachLanguage) {
    for (const std::string& code : shipped_codes())
        for (const GlossaryTerm& term : terms()) {
            Desk desk;
            desk.strings = speaking(code);
            std::string form = text_of_term(desk.strings, term.id, "forms");
            open_with_goal(desk, "X " + form.substr(0, form.find(',')) + " y.");
            const std::string anchor = "term." + std::string(term.id);
            ASSERT_TRUE(desk.anchors.find(anchor)) << code << " " << term.id;
            desk.click(anchor);
            EXPECT_TRUE(desk.anchors.find("card.term")) << code << " " << term.id;
            EXPECT_EQ(desk.panels.glossary.open, term.id);
        }
}

TEST(Glossary, EveryTermIsInTheSheetOfTheHelpMenu) {
    Desk desk;
    desk.frame(2);
    desk.choose("help", "glossary");
    desk.frame(2);
    ASSERT_TRUE(desk.anchors.find("card.glossary"));
    for (const GlossaryTerm& term : terms()) {
        desk.click("glossary." + std::string(term.id));
        EXPECT_EQ(desk.panels.glossary.shown, term.id);
        EXPECT_TRUE(desk.anchors.find("glossary.picture")) << term.id;
    }
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.glossary"));
}

TEST(Glossary, ArrowKeysGoThroughTheTermsOfTheSheet) {
    Desk desk;
    desk.panels.sheet = Sheet::glossary;
    desk.frame(3);
    std::set<std::string> seen;
    for (std::size_t i = 0; i < terms().size(); ++i) {
        seen.insert(desk.panels.glossary.shown);
        desk.key({key::down});
        desk.frame(2);
    }
    EXPECT_EQ(seen.size(), terms().size());
}

TEST(Glossary, ATermOpensByTabAndEnterAndClosesByEscape) {
    Desk desk;
    open_with_goal(desk, "A wire.");
    desk.key({key::tab, true});  // into the first card
    desk.frame();
    for (int i = 0; i < 60 && desk.panels.keyboard.focus != "term.wire"; ++i) desk.key({key::tab}), desk.frame();
    ASSERT_EQ(desk.panels.keyboard.focus, "term.wire");
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("card.term"));
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.term"));
}

TEST(Glossary, AClickElsewhereClosesTheTerm) {
    Desk desk;
    open_with_goal(desk, "A wire.");
    desk.click("term.wire");
    ASSERT_TRUE(desk.anchors.find("card.term"));
    desk.click("viewport");
    EXPECT_FALSE(desk.anchors.find("card.term"));
}

TEST(Glossary, MentionsAreTheFirstWholeWordsAndTheLongestForms) {
    const Strings strings = english();
    const std::string text = "Rewired, hardwire: a Wire with a negative weight, and another wire.";
    const std::vector<Mention> found = mentions_in(strings, text);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(text.substr(found[0].begin, found[0].end - found[0].begin), "Wire");
    EXPECT_EQ(text.substr(found[1].begin, found[1].end - found[1].begin), "negative weight");
    EXPECT_EQ(found[1].term->id, "inhibits");
    EXPECT_EQ(mentions_in(strings, text, {"wire"}).size(), 1u);
    EXPECT_TRUE(mentions_in(strings, "").empty());
}

TEST(Glossary, PicturesAreStillWhereMotionIsReduced) {
    const auto drawn_at = [](bool still, double seconds) {
        Desk desk;
        desk.view.program.reduce_motion = still;
        desk.panels.sheet = Sheet::glossary;
        desk.panels.glossary.shown = "weight";
        desk.frame(3);
        desk.view.wall_seconds = seconds;
        desk.frame();
        std::vector<std::pair<float, float>> all;
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int l = 0; l < data.CmdListsCount; ++l)
            for (const ImDrawVert& v : data.CmdLists[l]->VtxBuffer) all.emplace_back(v.pos.x, v.pos.y);
        return all;
    };
    EXPECT_EQ(drawn_at(true, 10), drawn_at(true, 11.1));
    EXPECT_NE(drawn_at(false, 10), drawn_at(false, 11.1));
}

TEST(Glossary, TheTermClosesWhenItsWordIsGone) {
    Desk desk;
    open_with_goal(desk, "A wire.");
    desk.click("term.wire");
    ASSERT_TRUE(desk.anchors.find("card.term"));
    desk.opened.goal = "Nothing.";
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.term"));
}

}  // namespace
}  // namespace braitenlab::tests::glossary_test
