// Mutated scenes that pass every check are run: no number in range may crash or hang a world.
#include <gtest/gtest.h>

#include "core/maths/random.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::hostile_world_test {
namespace {

// Changes one to three digits, signs or words of the text.
std::string changed(std::string text, maths::Random& chance) {
    for (std::uint32_t n = chance.next() % 3 + 1; n > 0; --n) {
        const std::size_t digit = text.find_first_of("0123456789", chance.next() % text.size());
        if (digit == std::string::npos) continue;
        if (chance.next() % 4 == 0)
            text.insert(digit, "-");
        else if (chance.next() % 4 == 0)
            text.insert(digit, 1, static_cast<char>('0' + chance.next() % 10));
        else
            text[digit] = static_cast<char>('0' + chance.next() % 10);
    }
    return text;
}

TEST(World, RunsEverySceneThatPassesTheChecks) {
    maths::Random chance{11, 3};
    int ran = 0;
    for (const auto& path : tests::shipped_scenes()) {
        const std::string text = write_scene(*load_scene(path)) +
                                 "\n[obstacle.odd]\nx = 2\nmass = 5\n[[obstacle.odd.corner]]\nx = 1\ny = 0\n"
                                 "[[obstacle.odd.corner]]\nx = 0\ny = 1\n[[obstacle.odd.corner]]\nx = -1\ny = -1\n"
                                 "[zone.odd]\nx = 3\nlength = 4\nwidth = 3\nslope = 9\npull = 5\nwind_x = 1\n";
        for (int i = 0; i < 60; ++i) {
            auto scene = parse_scene(changed(text, chance), "stranger.toml");
            if (!scene) continue;
            scene->ecology.population = std::min(scene->ecology.population, 100);  // limits the time of the test
            auto world = World::create(*scene, 3);
            ASSERT_TRUE(world) << world.error().text();
            for (int tick = 0; tick < 5; ++tick) world->step();
            ++ran;
        }
    }
    EXPECT_GT(ran, 200);
}

}  // namespace
}  // namespace braitenlab::tests::hostile_world_test
