// The card of what the check of an exercise has found.
#include <algorithm>

#include <gtest/gtest.h>

#include "desk.h"

namespace braitenlab::tests::findings_card_test {
namespace {

using namespace ui;

std::vector<Finding> some_findings() {
    const Error outside{"'lamp' is at (30, 0), outside the arena of 12 × 12 m; move it inside", "/home/me/strike.toml",
                        41};
    std::vector<Finding> found(2);
    found[0].said = {NoticeKind::failure, "findings.start_fails", "3", "1. It touches the lamp"};
    found[0].measures = {{.value = 1.25f, .needed = 0.6f, .unit = "m", .at_most = true, .best = true}};
    found[1].said = {.kind = NoticeKind::notice, .words = outside.text(), .error = outside};
    return found;
}

bool says(const Desk& desk, std::string_view words) {
    std::string all;
    for (const Written& written : desk.written) all += written.words + " ";
    std::replace(all.begin(), all.end(), '\n', ' ');
    return all.find(words) != std::string::npos;
}

TEST(FindingsCard, ListsEachWithItsPlaceAndValuesAndCloses) {
    Desk desk;
    const std::vector<Finding> found = some_findings();
    desk.view.findings = &found;
    desk.frame(4);
    ASSERT_TRUE(desk.anchors.find("card.findings"));
    EXPECT_TRUE(says(desk, "start 3 fails at step 1. It touches the lamp; best\u00a01.25\u00a0m"));
    EXPECT_TRUE(says(desk, "strike.toml:41: ")) << "without the folder";
    EXPECT_FALSE(says(desk, "/home/me"));
    desk.click("findings.close");
    EXPECT_TRUE(desk.last<HideFindingsRequest>());
}

TEST(FindingsCard, GoesBackToTheSheetOfTheAuthorWhereItsSceneIsKept) {
    Desk desk;
    const std::vector<Finding> found = some_findings();
    desk.view.findings = &found;
    desk.frame(4);
    EXPECT_FALSE(desk.anchors.find("findings.edit")) << "the file was written elsewhere";
    desk.view.documents.has_draft = true;
    desk.frame(4);
    desk.click("findings.edit");
    EXPECT_EQ(desk.actions(), std::vector{Action::edit_again});
}

TEST(FindingsCard, IsNotThereWithoutFindingsAndInALecture) {
    Desk desk;
    const std::vector<Finding> none, found = some_findings();
    desk.view.findings = &none;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.findings"));
    desk.view.findings = &found;
    desk.view.lecture = true;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.findings"));
}

}  // namespace
}  // namespace braitenlab::tests::findings_card_test
