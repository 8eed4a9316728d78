#include "core/scene/subject.h"

#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"

namespace braitenlab::tests::subject_test {
namespace {

Kind kind(const char* name) {
    Kind made;
    made.name = name;
    made.sensors = {{.name = "SL"}, {.name = "SR"}};
    made.brain = make_graph({.LL = 1});
    return made;
}

TEST(Subject, IsTheKindOfTheFirstStart) {
    Scene scene;
    scene.kinds = {kind("lamp-lover"), kind("student")};
    EXPECT_EQ(subject_kind(scene), -1) << "no start";
    scene.starts = {{.name = "one", .kind = "student"}, {.name = "two", .kind = "lamp-lover"}};
    EXPECT_EQ(subject_kind(scene), 1);
}

TEST(Subject, ASubmissionIsTheBrainTheSensorsAndTheBody) {
    const Kind given = kind("student");
    for (void (*change)(Kind&) : {+[](Kind& k) { k.brain = make_graph({.LR = 2}); },
                                  +[](Kind& k) { k.sensors.pop_back(); }, +[](Kind& k) { k.body.mismatch = 0.2f; }}) {
        Kind changed = given;
        change(changed);
        ASSERT_NE(changed, given);
        EXPECT_TRUE(differ_in_submission_only(changed, given));
        EXPECT_EQ(with_submission(given, submission_of(changed)), changed);
    }
    for (void (*change)(Kind&) : {+[](Kind& k) { k.name = "other"; }, +[](Kind& k) { k.role = Role::prey; },
                                  +[](Kind& k) { k.driver = Driver::wander; }, +[](Kind& k) { k.hidden = true; }}) {
        Kind changed = given;
        change(changed);
        EXPECT_FALSE(differ_in_submission_only(changed, given));
        EXPECT_EQ(with_submission(given, submission_of(changed)), given);
    }
}

}  // namespace
}  // namespace braitenlab::tests::subject_test
