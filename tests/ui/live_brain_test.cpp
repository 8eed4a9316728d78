// The large picture of the brain below the scene of a lecture.
#include "core/scene/sensor_pairs.h"
#include "desk.h"

namespace braitenlab::tests::live_brain_test {

namespace {

bool overlap(Rect a, Rect b) {
    return a.x < b.x + b.w - 0.5f && b.x < a.x + a.w - 0.5f && a.y < b.y + b.h - 0.5f && b.y < a.y + a.h - 0.5f;
}
bool is_inside(Rect a, Rect b) {
    return a.x >= b.x - 0.5f && a.y >= b.y - 0.5f && a.x + a.w <= b.x + b.w + 0.5f && a.y + a.h <= b.y + b.h + 0.5f;
}
bool shows(const Desk& desk, std::string_view words) {
    return std::any_of(desk.written.begin(), desk.written.end(),
                       [&](const ui::Written& w) { return w.words == words; });
}

// A window and the scale that lecture mode has in it.
struct Size {
    float width, height, scale;
};
constexpr Size sizes[]{{1024, 768, 1.6f}, {1280, 800, 1.6f}, {1920, 1080, 2.0f}, {2560, 1440, 2.0f}};

constexpr const char* scenes[]{"2a-coward", "2b-aggressor", "2c",       "3b-explorer",
                               "3c-values", "5-logic",      "tortoise", "7-mnemotrix"};

void begin_lecture(Desk& desk, const char* scene) {
    desk.now = shipped_scene(scene);
    desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
    desk.view.lecture = true;
    desk.frame(3);
}

std::vector<Rect> weights(const Desk& desk) {
    std::vector<Rect> found;
    for (const Node& from : desk.now.brains[0]->nodes)
        for (const Node& to : desk.now.brains[0]->nodes)
            if (const Rect* pill = desk.anchors.find("lecture.weight." + from.name + "." + to.name))
                found.push_back(*pill);
    return found;
}

}  // namespace

TEST(LiveBrain, ItsTextIsAtLeastTheFiftiethPartOfTheWindowHigh) {
    for (const Size& size : sizes)
        for (const char* scene : scenes) {
            SCOPED_TRACE(scene + std::string(" at ") + std::to_string(size.width));
            Desk desk(size.width, size.height, size.scale, true);
            begin_lecture(desk, scene);
            int texts = 0;
            for (const ui::Written& w : desk.written) {
                if (!is_inside(w.rect, desk.layout.hint_bar)) continue;
                ++texts;
                EXPECT_GE(w.rect.h, 0.022f * size.height) << w.words;
            }
            EXPECT_GE(texts, 6);
        }
}

TEST(LiveBrain, NoTextCoversAnotherOrLeavesThePicture) {
    for (const Size& size : sizes)
        for (const std::string& code : shipped_codes())
            for (const char* scene : scenes) {
                SCOPED_TRACE(scene + std::string(" ") + code + " at " + std::to_string(size.width));
                Desk desk(size.width, size.height, size.scale, true);
                desk.strings = speaking(code);
                begin_lecture(desk, scene);
                const Rect bar = desk.layout.hint_bar;
                std::vector<Rect> texts;
                for (const ui::Written& w : desk.written) {
                    if (!overlap(w.rect, bar)) continue;
                    texts.push_back(w.rect);
                    EXPECT_TRUE(is_inside(w.rect, bar)) << w.words;
                }
                for (std::size_t i = 0; i < texts.size(); ++i)
                    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(texts[i], texts[j])) << i << " " << j;
                const auto pills = weights(desk);
                for (std::size_t i = 0; i < pills.size(); ++i)
                    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(pills[i], pills[j])) << i << " " << j;
            }
}

TEST(LiveBrain, LeavesRoomForTheWatchedDiagram) {
    for (const Size& size : sizes)
        for (const char* scene : scenes) {
            SCOPED_TRACE(scene + std::string(" at ") + std::to_string(size.width));
            Desk desk(size.width, size.height, size.scale, true);
            begin_lecture(desk, scene);
            const float large = desk.layout.hint_bar.h;
            desk.view.settings.watching = true;
            desk.frame(3);
            EXPECT_LT(desk.layout.hint_bar.h, 0.7f * large);
            for (const ui::Written& w : desk.written)
                EXPECT_TRUE(!overlap(w.rect, desk.layout.hint_bar) || is_inside(w.rect, desk.layout.hint_bar))
                    << w.words;
            const auto pills = weights(desk);
            for (std::size_t i = 0; i < pills.size(); ++i) {
                EXPECT_TRUE(is_inside(pills[i], desk.layout.hint_bar)) << i;
                for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(pills[i], pills[j])) << i << " " << j;
            }
        }
}

TEST(LiveBrain, ShowsEveryEyeThatTheBrainReadsAlsoBesideTheDiagram) {
    for (const Size& size : sizes)
        for (const std::string& code : shipped_codes()) {
            SCOPED_TRACE(code + " at " + std::to_string(size.width));
            Desk desk(size.width, size.height, size.scale, true);
            desk.strings = speaking(code);
            begin_lecture(desk, "tortoise");
            desk.view.settings.watching = true;
            desk.frame(3);
            const BrainGraph& brain = *desk.now.brains[0];
            int eyes = 0;
            std::vector<Rect> texts;
            for (const Sensor& sensor : desk.now.scene->kinds[0].sensors) {
                const Node* node = find_node(brain, sensor.name);
                if (!node || std::none_of(brain.wires.begin(), brain.wires.end(),
                                          [&](const Wire& wire) { return wire.from == node->id; }))
                    continue;
                ++eyes;
                const Rect eye = desk.where("lecture.eye." + sensor.name);
                EXPECT_TRUE(is_inside(eye, desk.layout.hint_bar)) << sensor.name;
                EXPECT_FALSE(overlap(eye, desk.where("lecture.left"))) << sensor.name;
                int numbers = 0;
                for (const ui::Written& w : desk.written) numbers += is_inside(w.rect, eye);
                EXPECT_EQ(numbers, 2) << sensor.name << ": its name and its number";
            }
            EXPECT_GE(eyes, 5);
            for (const ui::Written& w : desk.written) {
                if (!overlap(w.rect, desk.layout.hint_bar)) continue;
                for (const Rect& other : texts) EXPECT_FALSE(overlap(other, w.rect)) << w.words;
                texts.push_back(w.rect);
            }
        }
}

TEST(LiveBrain, TheBarOfAnEyeCoversNoText) {
    int bars = 0;
    for (const Size& size : sizes)
        for (const std::string& code : shipped_codes()) {
            SCOPED_TRACE(code + " at " + std::to_string(size.width));
            Desk desk(size.width, size.height, size.scale, true);
            desk.strings = speaking(code);
            begin_lecture(desk, "tortoise");
            desk.view.settings.watching = true;
            desk.frame(3);
            for (const auto& [id, bar] : desk.anchors.all()) {
                if (!id.starts_with("lecture.bar.")) continue;
                ++bars;
                for (const ui::Written& w : desk.written) EXPECT_FALSE(overlap(w.rect, bar)) << id << " " << w.words;
            }
        }
    EXPECT_GT(bars, 0);
}

TEST(LiveBrain, BesideTheDiagramTheEyesOfAPairAreOneBelowTheOther) {
    Desk desk(1024, 768, 1.4f, true);
    begin_lecture(desk, "3c-values");
    desk.view.settings.watching = true;
    desk.frame(3);
    int pairs = 0;
    for (const KindPair& pair : sensor_pairs(desk.now.scene->kinds[0])) {
        const Rect* left = desk.anchors.find("lecture.eye." + pair.sensors.left);
        const Rect* right = desk.anchors.find("lecture.eye." + pair.sensors.right);
        if (!left || !right) continue;
        ++pairs;
        EXPECT_EQ(left->x, right->x) << pair.name;
        EXPECT_LT(left->y, right->y) << pair.name;
    }
    EXPECT_GE(pairs, 2);
}

TEST(LiveBrain, ShowsEyesWeightsAndWheels) {
    Desk desk(1280, 800, 1.6f, true);
    begin_lecture(desk, "2b-aggressor");
    EXPECT_EQ(weights(desk).size(), 2u);
    EXPECT_TRUE(shows(desk, "SL"));
    EXPECT_TRUE(shows(desk, "MR"));
    EXPECT_LT(desk.where("lecture.wires").x, desk.where("lecture.left").x);
    EXPECT_LT(desk.where("lecture.left").y, desk.where("lecture.right").y);
}

TEST(LiveBrain, TheBiasOfAWheelIsBetweenItsNameAndItsNumber) {
    for (const Size& size : {Size{1024, 768, 1.4f}, sizes[1], sizes[2], sizes[3]})
        for (const std::string& code : shipped_codes()) {
            SCOPED_TRACE(code + " at " + std::to_string(size.width));
            Desk desk(size.width, size.height, size.scale, true);
            desk.strings = speaking(code);
            begin_lecture(desk, "2b-aggressor");
            for (const auto& [motor, place] : {std::pair{"ML", "lecture.left"}, {"MR", "lecture.right"}}) {
                const Rect bias = desk.where(std::string("lecture.bias.") + motor), row = desk.where(place);
                EXPECT_TRUE(is_inside(bias, row));
                for (const ui::Written& w : desk.written)
                    if (is_inside(w.rect, row) && w.rect.x < bias.x - 1) {
                        EXPECT_LE(w.rect.x + w.rect.w, bias.x) << w.words;
                    } else if (is_inside(w.rect, row) && w.rect.x > bias.x + 1) {
                        EXPECT_GE(w.rect.x, bias.x + bias.w) << w.words;
                    }
            }
        }
    Desk desk(1280, 800, 1.6f, true);
    begin_lecture(desk, "2b-aggressor");
    EXPECT_TRUE(shows(desk, "bias +0.10"));
    auto brain = std::make_shared<BrainGraph>(*desk.now.brains[0]);
    find_node(*brain, std::string("ML"))->bias = 0;
    find_node(*brain, std::string("MR"))->silenced = true;
    desk.now.brains[0] = brain;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("lecture.bias.ML"));
    EXPECT_FALSE(desk.anchors.find("lecture.bias.MR")) << "a stopped wheel has no sum";
}

TEST(LiveBrain, ABiasHasTheNameOfItsSliderInLittleRoom) {
    Desk desk(1024, 768, 1.4f, true);
    desk.strings = speaking("de");
    begin_lecture(desk, "2b-aggressor");
    EXPECT_TRUE(shows(desk, "LM +0,10"));
    EXPECT_TRUE(shows(desk, "RM +0,10"));
}

TEST(LiveBrain, AHiddenBrainHasNoBias) {
    Desk desk(1280, 800, 1.6f, true);
    begin_lecture(desk, "2b-aggressor");
    desk.view.settings.revealed.brain = false;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("lecture.bias.ML"));
}

TEST(LiveBrain, ABrainWithHiddenNeuronsIsShownWholeBetweenEyesAndWheels) {
    for (const Size& size : sizes)
        for (const char* scene : {"5-logic", "tortoise"}) {
            SCOPED_TRACE(scene + std::string(" at ") + std::to_string(size.width));
            Desk desk(size.width, size.height, size.scale, true);
            begin_lecture(desk, scene);
            const Rect wires = desk.where("lecture.wires");
            std::vector<Rect> neurons;
            for (const Node& node : desk.now.brains[0]->nodes)
                if (node.kind == NodeKind::neuron) neurons.push_back(desk.where("lecture.neuron." + node.name));
            EXPECT_GE(neurons.size(), 5u);
            for (std::size_t i = 0; i < neurons.size(); ++i) {
                EXPECT_TRUE(is_inside(neurons[i], wires)) << i;
                for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(neurons[i], neurons[j])) << i << " " << j;
            }
            desk.view.settings.revealed.brain = false;
            desk.frame(2);
            EXPECT_FALSE(desk.anchors.find("lecture.neuron." + desk.now.brains[0]->nodes.back().name));
        }
}

TEST(LiveBrain, ManyEyesAreInTheOrderOfTheirMounts) {
    Desk desk(1280, 800, 1.6f, true);
    begin_lecture(desk, "3c-values");
    const Rect bar = desk.layout.hint_bar;
    std::vector<std::pair<float, float>> mounts;  // y of the middle on the screen, y of the mount
    for (const Sensor& sensor : desk.now.scene->kinds[0].sensors)
        if (const Rect* eye = desk.anchors.find("lecture.eye." + sensor.name)) {
            EXPECT_TRUE(is_inside(*eye, bar)) << sensor.name;
            mounts.push_back({eye->y, sensor.y});
        }
    EXPECT_GE(mounts.size(), 8u);
    std::sort(mounts.begin(), mounts.end());
    for (std::size_t i = 1; i < mounts.size(); ++i) {
        EXPECT_GT(mounts[i].first, mounts[i - 1].first);
        EXPECT_LE(mounts[i].second, mounts[i - 1].second);
    }
}

TEST(LiveBrain, ABrainWithNeuronsHasNoCharacterInOneWord) {
    for (const char* scene : scenes) {
        SCOPED_TRACE(scene);
        Desk desk(1280, 800, 1.6f, true);
        begin_lecture(desk, scene);
        const auto& nodes = desk.now.brains[0]->nodes;
        const bool has_neurons =
            std::any_of(nodes.begin(), nodes.end(), [](const Node& node) { return node.kind == NodeKind::neuron; });
        EXPECT_EQ(desk.anchors.find("lecture.character") != nullptr, !has_neurons);
        EXPECT_TRUE(desk.anchors.find("lecture.speed"));
    }
}

TEST(LiveBrain, HidesTheBrainTheCharacterAndTheTitle) {
    Desk desk(1280, 800, 1.6f, true);
    begin_lecture(desk, "2b-aggressor");
    const std::string title = desk.now.scene->title;
    ASSERT_TRUE(shows(desk, "aggressor") && shows(desk, title));
    desk.view.settings.revealed.character = false;
    desk.frame(2);
    EXPECT_FALSE(shows(desk, "aggressor"));
    EXPECT_TRUE(shows(desk, title));
    EXPECT_EQ(weights(desk).size(), 2u);
    desk.view.settings.revealed.brain = desk.view.settings.revealed.title = false;
    desk.frame(2);
    EXPECT_FALSE(shows(desk, title));
    EXPECT_TRUE(weights(desk).empty());
    EXPECT_TRUE(hidden_brains(desk.view).at(0)) << "nor on the deck";
}

TEST(LiveBrain, WhileTheAudienceIsAskedTheWheelsOfAHiddenBrainTellNothing) {
    Desk desk(1280, 800, 1.6f, true);
    begin_lecture(desk, "2b-aggressor");
    Revealed& revealed = desk.view.settings.revealed;
    const auto numbers = [&] {
        desk.frame(2);
        return std::count_if(desk.written.begin(), desk.written.end(), [&](const ui::Written& w) {
            const Rect left = desk.where("lecture.left"), right = desk.where("lecture.right");
            return (is_inside(w.rect, left) || is_inside(w.rect, right)) && w.words.find('.') != std::string::npos;
        });
    };
    revealed.brain = false;
    EXPECT_EQ(numbers(), 2) << "hidden by its own key";
    revealed.asks_first = true;
    EXPECT_EQ(numbers(), 0);
    EXPECT_TRUE(shows(desk, "?"));
    revealed.brain = true;
    EXPECT_GE(numbers(), 2);
}

TEST(LiveBrain, KeysHideAndRevealAndAreNotShownToTheAudience) {
    Desk desk(1280, 800, 1.6f, true);
    begin_lecture(desk, "2b-aggressor");
    desk.key({'T', false, true});
    desk.key({'C', false, true});
    desk.key({'B', false, true});
    EXPECT_EQ(desk.actions(), (std::vector{Action::hide_title, Action::hide_character, Action::hide_brain}));
    EXPECT_TRUE(desk.panels.lecture.pressed.empty());
}

TEST(LiveBrain, ScenesOfPredatorsAndPreyShowTheirNumbers) {
    Desk desk(1280, 800, 1.6f, true);
    begin_lecture(desk, "predator-prey");
    EXPECT_TRUE(desk.anchors.find("lecture.predators"));
    EXPECT_FALSE(desk.anchors.find("lecture.wires"));
}

}  // namespace braitenlab::tests::live_brain_test
