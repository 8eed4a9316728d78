#include "desk.h"

namespace braitenlab::tests {

struct OpenMenu : testing::Test {
    Desk desk;
    std::vector<CatalogueEntry> catalogue{{"05-aggressor", "/x/05-aggressor.toml", "Aggressor", "", 5},
                                          {"2a-coward", "/x/2a-coward.toml", "Coward", "It turns away."}};

    OpenMenu() {
        desk.view.catalogue = &catalogue;
        desk.view.opened = "05-aggressor";
        desk.frame(2);
    }
    std::vector<std::string> opened() const {
        std::vector<std::string> paths;
        for (const Request& request : desk.all)
            if (const auto* open = std::get_if<OpenRequest>(&request)) paths.push_back(open->path);
        return paths;
    }
};

TEST_F(OpenMenu, OpensWhatIsClickedAndCloses) {
    desk.click("button.open");
    desk.frame(2);
    ASSERT_TRUE(desk.anchors.find("open.2a-coward"));
    desk.click("open.2a-coward");
    desk.frame(2);
    EXPECT_EQ(opened(), std::vector<std::string>{"/x/2a-coward.toml"});
    EXPECT_FALSE(desk.anchors.find("open.2a-coward"));
}

TEST_F(OpenMenu, CanBeUsedByKeysAlone) {
    desk.key({'O', true});
    desk.frame(2);
    desk.key({key::tab});
    desk.frame(2);
    desk.key({key::enter});
    desk.frame(2);
    EXPECT_EQ(opened(), std::vector<std::string>{"/x/2a-coward.toml"});
}

TEST_F(OpenMenu, IsWalkedWithArrowsAndKeepsTheFocusInside) {
    desk.click("button.open");
    desk.frame(2);
    const auto after = [&](KeyPress press) {
        desk.key(press);
        desk.frame(2);
        return desk.panels.keyboard.focus;
    };
    EXPECT_EQ(after({key::down}), "open.05-aggressor");
    EXPECT_EQ(after({key::down}), "open.2a-coward");
    EXPECT_EQ(after({key::down}), "open.05-aggressor") << "round and round";
    EXPECT_EQ(after({key::up}), "open.2a-coward");
    EXPECT_EQ(after({key::tab, false, true}), "open.05-aggressor");
    EXPECT_EQ(after({key::escape}), "");
    EXPECT_TRUE(opened().empty());
}

TEST_F(OpenMenu, ClosesOnEscAndOnAClickElsewhereAndOpensNothing) {
    desk.key({'O', true});
    desk.frame(2);
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.open"));
    desk.click("button.open");
    desk.frame(2);
    desk.click("brain.picture");
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.open"));
    EXPECT_TRUE(opened().empty());
}

}  // namespace braitenlab::tests
