#include "app/files/edits_json.h"

#include <gtest/gtest.h>

#include "tests/core/sessions.h"

namespace braitenlab::tests::edits_json_test {
namespace {

TEST(EditsJson, EveryEditIsUndoneAndRedoneInARunThatIsContinued) {
    constexpr std::size_t all = 1000;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        Session session = open_session(furnished());
        maths::Random chance{seed, 1};
        for (int i = 0; i < 40; ++i) {
            (void)session.apply(any_edit(session, chance));
            if (i % 8 == 7) session.undo();
        }
        const auto edits = read_edits(edits_json(session.edits(), all));
        ASSERT_TRUE(edits) << "seed " << seed;
        Session again = Session::resume(session.save(), {}, *edits);
        ASSERT_EQ(again.undo_depth(), session.undo_depth());
        ASSERT_EQ(again.redo_depth(), session.redo_depth());
        while (session.undo()) {
            EXPECT_TRUE(again.undo());
            ASSERT_EQ(again.edited_scene(), session.edited_scene()) << "seed " << seed;
        }
        while (session.redo()) {
            EXPECT_TRUE(again.redo());
            ASSERT_EQ(again.edited_scene(), session.edited_scene()) << "seed " << seed;
        }
    }
}

TEST(EditsJson, KeepTheLastSteps) {
    Session session = open_session(tests::crowd(4));
    for (const float value : {0.1f, 0.4f, 0.9f}) ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, value}));
    Session again = Session::resume(session.save(), {}, read_edits(edits_json(session.edits(), 2)).value_or(Edits{}));
    EXPECT_EQ(again.undo_depth(), 2);
    again.undo();
    EXPECT_EQ(dial(again, Dial::LL), 0.4f);
}

TEST(EditsJson, RefuseAnotherValue) {
    for (const char* text :
         {"[]", "{}", R"({"done": [], "undone": [7]})", R"({"done": [{}], "undone": []})",
          R"({"done": [{"back": [{"Fly": {}}], "again": [], "tick": 0, "generation": 0}], "undone": []})"})
        EXPECT_FALSE(read_edits(nlohmann::json::parse(text))) << text;
}

}  // namespace
}  // namespace braitenlab::tests::edits_json_test
