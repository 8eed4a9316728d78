#include "core/scene/enums.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/scene/scene_file.h"
#include "core/world/world.h"

namespace braitenlab {
namespace {

enum class Colour { red, green };
inline constexpr auto complete = std::to_array<Word<Colour>>({{Colour::red, "red"}, {Colour::green, "green"}});
inline constexpr auto without_green = std::to_array<Word<Colour>>({{Colour::red, "red"}});
inline constexpr auto in_wrong_order = std::to_array<Word<Colour>>({{Colour::green, "green"}, {Colour::red, "red"}});
static_assert(is_complete_table<complete>());
static_assert(!is_complete_table<without_green>());
static_assert(!is_complete_table<in_wrong_order>());

TEST(Enums, GiveEveryEnumeratorAUniqueWord) {
    const auto check = [](const auto& table) {
        std::set<std::string_view> words;
        for (const auto& row : table) {
            EXPECT_EQ(word(row.value), row.word);
            EXPECT_TRUE(words.insert(row.word).second) << row.word;
        }
    };
    check(channel_table), check(role_table), check(sensor_shape_table), check(sensor_response_table);
    check(driver_table), check(boundary_table), check(surface_table), check(motor_table);
    check(node_kind_table), check(responses);
}

TEST(Enums, GiveNoWordToAnInvalidValue) { EXPECT_EQ(word(static_cast<Channel>(channel_count)), ""); }

// A vehicle with one sensor for the channel, 3 m before a source of the same channel.
std::string scene_with(std::string_view channel) {
    const std::string name(channel);
    return "format = 1\n[kind.watcher]\n[kind.watcher.sensor.S]\nchannel = \"" + name +
           "\"\n[kind.watcher.brain]\nLL = 0\n[vehicle.one]\nkind = \"watcher\"\n[source.near]\nchannel = \"" + name +
           "\"\nx = 3\n";
}

TEST(Enums, LetASensorOfEverySourceChannelReadASourceInFrontOfIt) {
    for (const ChannelTraits& row : channel_table) {
        if (!row.is_source) continue;
        const auto scene = parse_scene(scene_with(row.word), "scene.toml");
        ASSERT_TRUE(scene) << scene.error().text();
        const auto world = World::create(*scene, 1);
        ASSERT_TRUE(world) << world.error().text();
        Snapshot now;
        world->capture(now);
        EXPECT_GT(now.sensed.at(0), 0) << row.word;
    }
}

TEST(Enums, WriteAndReadBackEveryChannel) {
    for (const ChannelTraits& row : channel_table) {
        const auto scene = parse_scene(scene_with(row.word), "scene.toml");
        ASSERT_TRUE(scene) << scene.error().text();
        EXPECT_EQ(scene->kinds[0].sensors[0].channel, row.value);
        const auto again = parse_scene(write_scene(*scene), "scene.toml");
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ(*again, *scene);
    }
}

}  // namespace
}  // namespace braitenlab
