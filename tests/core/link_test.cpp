#include "core/io/link.h"

#include <gtest/gtest.h>

#include "core/maths/random.h"
#include "core/scene/scene_file.h"
#include "core/scene/schema.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::link_test {
namespace {

using io::decode_link, io::encode_link, io::is_link;

Scene shipped(const std::string& name) {
    return *load_scene(std::string(BRAITENLAB_SOURCE) + "/exercises/scenes/" + name + ".toml");
}

std::string reason(std::string_view link) {
    const auto linked = decode_link(link);
    return linked ? "opened" : linked.error().text();
}

TEST(Link, HoldsASceneWithItsBrains) {
    for (const char* name : {"2a-coward", "3a-love", "predator-prey", "wind-tunnel"}) {
        Scene scene = shipped(name);
        const std::string link = encode_link(scene);
        const auto linked = decode_link(link);
        ASSERT_TRUE(linked) << linked.error().text();
        EXPECT_TRUE(linked->exercise.empty());
        scene.name = linked->scene.name;  // that of a file
        EXPECT_EQ(linked->scene, scene) << name;
        EXPECT_LT(link.size(), io::safe_link) << name;
    }
}

TEST(Link, HasOnlyCharactersOfAnAddress) {
    const std::string link = encode_link(shipped("predator-prey"));
    EXPECT_EQ(link.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_", 4),
              std::string::npos);
    EXPECT_TRUE(link.starts_with("#b1."));
}

// Written by another program: Python's zlib and base64.
TEST(Link, StaysReadableInLaterVersionsOfTheLab) {
    const auto linked = decode_link(
        "#b1.eNpLyy_KTSxRsFUw5CrJLMlJBbKUvFMLSpS4uKKzM_NS9JLzyxOLUmKB3LLUjMzknFS9tMyi4pJYLpAsSDVEgRJXBcgQPVMuAEFiGWk");
    ASSERT_TRUE(linked) << linked.error().text();
    EXPECT_EQ(linked->scene.title, "Kept");
    ASSERT_EQ(linked->scene.starts.size(), 1u);
    EXPECT_EQ(linked->scene.starts.front().x, 1.5f);
}

TEST(Link, IsFoundBehindAnyAddress) {
    const std::string link = encode_link(shipped("2a-coward"));
    for (const std::string before : {"", "https://lab.example/", "file:///home/ben/lab.html", " \n https://a.b/?x=1"}) {
        EXPECT_TRUE(is_link(before + link)) << before;
        EXPECT_TRUE(decode_link(before + link + "\n")) << before;
    }
    for (const std::string text : {"", "#", "#b1", "#b.x", "#c1.x", "#bx.y", "#b12345.x", "2a-coward", "C:\\a#b1.toml",
                                   "notes#b1.toml", "https://a.b/", "https://a.b/#top"}) {
        EXPECT_FALSE(is_link(text)) << text;
        const bool is_broken = io::begins_like_link(text);
        EXPECT_NE(reason(text).find(is_broken ? "the link is damaged" : "no link of the lab"), std::string::npos)
            << text;
    }
}

TEST(Link, ThatIsBrokenBeforeItsVersionStillBeginsLikeALink) {
    for (const char* text : {"#b", "#bGARBAGE", "#b1", "#e1.x", "#e"}) EXPECT_TRUE(io::begins_like_link(text)) << text;
    for (const char* text : {"#b123xyz", "https://lab.example/#b123xyz", "#e"})
        EXPECT_EQ(reason(text), "the link is damaged; copy the whole link once more") << text;
    for (const char* text : {"", "#", "#top", "b1.x", "2a-coward"}) EXPECT_FALSE(io::begins_like_link(text)) << text;
}

TEST(Link, NamesAnExercise) {
    EXPECT_EQ(io::encode_exercise_link("05-aggressor"), "#e1.05-aggressor");
    const auto linked = decode_link("https://lab.example/#e1.05-aggressor");
    ASSERT_TRUE(linked);
    EXPECT_EQ(linked->exercise, "05-aggressor");
    EXPECT_NE(reason("#e1.../../secret").find("characters"), std::string::npos);
    EXPECT_NE(reason("#e1.").find("incomplete"), std::string::npos);
}

TEST(Link, OfALaterVersionSaysSo) {
    EXPECT_NE(reason("#b2.abc").find("version of this link is 2"), std::string::npos);
    EXPECT_NE(reason("#e9.abc").find("version of this link is 9"), std::string::npos);
}

TEST(Link, ThatIsCutIsReportedAsIncomplete) {
    const std::string link = encode_link(shipped("3a-love"));
    for (std::size_t length = 4; length < link.size(); length += 7)
        EXPECT_NE(reason(link.substr(0, length)).find("incomplete"), std::string::npos) << length;
}

TEST(Link, WithOneWrongCharacterIsReportedAsDamaged) {
    const std::string link = encode_link(shipped("3a-love"));
    for (std::size_t at = 4; at < link.size(); at += 11) {
        std::string wrong = link;
        wrong[at] = wrong[at] == 'A' ? 'B' : 'A';
        EXPECT_FALSE(decode_link(wrong)) << at;
    }
}

TEST(Link, ToAFaultySceneNamesItsLine) {
    Scene scene = shipped("2a-coward");
    scene.arena.width = -3;  // no program writes this
    EXPECT_NE(reason(encode_link(scene)).find("link:7: 'width' is -3, outside"), std::string::npos)
        << reason(encode_link(scene));
}

// 4 MiB and more from some kilobytes.
TEST(Link, ThatGrowsTooLargeIsRefusedEarly) {
    Scene scene = shipped("2a-coward");
    scene.story = std::string(40u << 20u, 'x');
    const std::string link = encode_link(scene);
    EXPECT_LT(link.size(), 100000u);
    EXPECT_NE(reason(link).find("larger than 4 MB"), std::string::npos) << reason(link);
    EXPECT_NE(reason("#b1." + std::string(9u << 20u, 'A')).find("larger than 4 MB"), std::string::npos);
}

TEST(Link, ThatIsChangedAtRandomNeverGivesAnInvalidScene) {
    const std::string link = encode_link(shipped("2a-coward"));
    maths::Random random(17, 0);
    const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random.next()) % count; };
    int opened = 0;
    for (int i = 0; i < 10000; ++i) {
        std::string changed = link;
        for (std::size_t change = below(3) + 1; change > 0; --change) {
            const auto at = below(changed.size() + 1);
            const std::size_t way = below(4);
            if (way == 0 && at < changed.size())
                changed[at] = static_cast<char>(below(256));
            else if (way == 1)
                changed.erase(at, below(9));
            else if (way == 2)
                changed.insert(at, 1, "AZaz09-_.#"[below(10)]);
            else
                changed.insert(at, changed.substr(at, 12));
        }
        const auto linked = decode_link(changed);
        if (!linked) {
            EXPECT_FALSE(linked.error().text().empty());
        } else if (linked->exercise.empty()) {
            ++opened;
            EXPECT_EQ(check_scene(linked->scene), std::nullopt) << changed;
        }
    }
    EXPECT_LT(opened, 1000) << "a change shows";
}

}  // namespace
}  // namespace braitenlab::tests::link_test
