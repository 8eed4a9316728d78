#include "ui/widgets/record_fields.h"

#include <cmath>
#include <set>

#include "desk.h"
#include "ui/widgets/card.h"

namespace braitenlab::tests::record_fields_test {

using namespace ui;

namespace {

struct Named {
    std::string name = "old";
    bool round = false;
    Boundary edge = Boundary::wall;
    float mass = 10, heading = 0;
    int count = 3;
};

template <class Visitor>
void describe_named(Visitor& v) {
    v.text("name", &Named::name, 8, "");
    v.flag("round", &Named::round, "");
    v.word("edge", &Named::edge, "");
    v.number("mass", &Named::mass, "kg", {0.05, 1000}, "");
    v.angle("heading", &Named::heading, {-180, 180}, "");
    v.number("count", &Named::count, "", {0, 20000}, "");
}

// A card with the rows of one record.
class Rows {
public:
    void frame(int count = 1) {
        for (; count > 0; --count) {
            seconds_ += 1.0 / 60;
            desk.anchors.begin();
            Ui ui{desk.strings, palette(Theme::dark), {}, 1, desk.anchors, desk.asked, {}, 1};
            ui.keyboard = &keyboard;
            ImGui::NewFrame();
            begin_keyboard(keyboard);
            if (begin_card(ui, card, "card.record", "Record", {20, 20, 304, 500})) {
                const FieldRows rows{ui, fields, sliders, seconds_, "named", "field.arena."};
                RecordFields<Named> visitor(rows, now, home, {});
                describe_named(visitor);
                if (auto edit = visitor.edit()) {
                    now = edit->to;
                    gestures.push_back(edit->gesture);
                }
            }
            end_card(ui, card);
            end_keyboard(keyboard);
            ImGui::Render();
        }
    }
    void click(std::string_view anchor, float share = 0.5f, int button = 0) {
        desk.point(anchor, share);
        frame(2);
        desk.button(button, true);
        frame(2);
        desk.button(button, false);
        frame(2);
    }
    void key(KeyPress press) {
        if (!sliders.typed.empty()) {
            if (press.key == key::enter) sliders.commit = true;
        } else if (!for_record_text(fields, press)) {
            if (press.key == key::escape) keyboard.focus.clear();
            keyboard.presses.push_back(press);
        }
        frame(2);
    }
    void type(const char* text) {
        desk.type(text);
        frame(2);
    }

    Desk desk;
    Named now, home;
    FieldsState fields;
    SliderState sliders;
    Keyboard keyboard;
    CardState card;
    std::vector<std::uint64_t> gestures;

private:
    double seconds_ = 0;
};

}  // namespace

TEST(RecordFields, HaveARowForEachValueOfTheRecord) {
    Rows rows;
    rows.frame(3);
    for (const char* key : {"name", "round.1", "edge.3", "mass", "heading", "count"})
        EXPECT_TRUE(rows.desk.anchors.find("named." + std::string(key))) << key;
}

TEST(RecordFields, TakeATypedNumberExactlyAndClampIt) {
    Rows rows;
    rows.frame(3);
    rows.click("named.mass", 0.97f);
    rows.type("12,34");
    rows.key({key::enter});
    EXPECT_FLOAT_EQ(rows.now.mass, 12.34f);
    rows.frame(30);
    rows.click("named.count", 0.97f);
    rows.type("1234");
    rows.key({key::enter});
    EXPECT_EQ(rows.now.count, 1234);
    rows.click("named.mass", 0.97f);
    rows.type("5000");
    rows.key({key::enter});
    EXPECT_FLOAT_EQ(rows.now.mass, 1000);
}

TEST(RecordFields, DragAcrossPowersOfTenInOneGesture) {
    Rows rows;
    rows.now.mass = 0.05f;
    rows.frame(3);
    const Rect r = rows.desk.where("named.mass");
    const float from = r.x + 118 + 8, to = r.x + r.w - 62 - 8, y = r.y + r.h / 2;
    rows.desk.point(from, y);
    rows.frame(2);
    rows.desk.button(0, true);
    std::vector<float> seen;
    for (int i = 0; i <= 20; ++i) {
        rows.desk.point(from + (to - from) * static_cast<float>(i) / 20, y);
        rows.frame();
        seen.push_back(rows.now.mass);
    }
    rows.desk.button(0, false);
    rows.frame(2);
    EXPECT_FLOAT_EQ(seen.back(), 1000);
    EXPECT_GT(seen[10], 1) << "half of the track covers the small values";
    EXPECT_LT(seen[10], 30);
    EXPECT_EQ(std::set<std::uint64_t>(rows.gestures.begin(), rows.gestures.end()).size(), 1u);
}

TEST(RecordFields, StepByKeysInProportionToTheValue) {
    Rows rows;
    rows.frame(3);
    rows.keyboard.focus = "named.mass";
    rows.frame();
    rows.key({key::right});
    EXPECT_FLOAT_EQ(rows.now.mass, 11);
    rows.now.mass = 500;
    rows.key({key::right, false, true});
    EXPECT_FLOAT_EQ(rows.now.mass, 501);
    rows.keyboard.focus = "named.heading";
    rows.frame();
    rows.key({key::right});
    EXPECT_NEAR(rows.now.heading, 0.017453f, 1e-5f);
}

TEST(RecordFields, ChooseWordsAndFlagsAsSeparateGestures) {
    Rows rows;
    rows.frame(3);
    rows.click("named.edge.3");
    EXPECT_EQ(rows.now.edge, Boundary::torus);
    rows.click("named.round.2");
    EXPECT_TRUE(rows.now.round);
    ASSERT_EQ(rows.gestures.size(), 2u);
    EXPECT_NE(rows.gestures[0], rows.gestures[1]);
    rows.click("named.edge.3");
    EXPECT_EQ(rows.gestures.size(), 2u) << "it is chosen already";
}

TEST(RecordFields, TakeATextAtEnterOrWhenTheFieldIsLeftAndDropItAtEscape) {
    Rows rows;
    rows.frame(3);
    rows.click("named.name");
    rows.type("new");
    EXPECT_EQ(rows.now.name, "old") << "not before Enter";
    rows.key({key::enter});
    EXPECT_EQ(rows.now.name, "new");
    rows.click("named.name");
    rows.type("other");
    rows.key({key::escape});
    rows.frame(3);
    EXPECT_EQ(rows.now.name, "new");
    rows.click("named.name");
    rows.type("third");
    rows.click("named.edge.2");
    rows.frame(2);
    EXPECT_EQ(rows.now.name, "third");
    rows.click("named.name");
    rows.type("much-too-long");
    rows.key({key::enter});
    EXPECT_EQ(rows.now.name, "third");
}

TEST(RecordFields, RestoreTheValueOfTheFileByARightClick) {
    Rows rows;
    rows.now.mass = 50;
    rows.frame(3);
    rows.click("named.mass", 0.5f, 1);
    EXPECT_FLOAT_EQ(rows.now.mass, 10);
}

TEST(RecordFields, ShowOnlyTheKeysAskedFor) {
    Desk desk;
    FieldsState fields;
    SliderState sliders;
    CardState card;
    desk.anchors.begin();
    Ui ui{desk.strings, palette(Theme::dark), {}, 1, desk.anchors, desk.asked, {}, 1};
    ImGui::NewFrame();
    if (begin_card(ui, card, "card.record", "Record", {20, 20, 304, 500})) {
        constexpr std::string_view only[]{"width", "edge"};
        (void)record_fields(FieldRows{ui, fields, sliders}, Arena{}, Arena{}, only);
    }
    end_card(ui, card);
    ImGui::Render();
    EXPECT_TRUE(desk.anchors.find("arena.width"));
    EXPECT_TRUE(desk.anchors.find("arena.edge.1"));
    EXPECT_FALSE(desk.anchors.find("arena.height"));
}

}  // namespace braitenlab::tests::record_fields_test
