// The watched diagram of a lecture, whose letters are larger than the cards and labels that hold them elsewhere.
#include "lecture_on_desk.h"
#include "ui/wiring/layout.h"

namespace braitenlab::tests::lecture_diagram_test {

namespace {

// A window and the scale that lecture mode has in it.
struct Size {
    float width, height, scale;
};
constexpr Size sizes[]{{1024, 768, 1.375f}, {1024, 768, 1.6f}, {1280, 800, 1.6f}, {1920, 1080, 2.0f}};

struct Diagram {
    Desk desk;
    Diagram(const Snapshot& now, const Size& size, const std::string& code)
        : desk(size.width, size.height, size.scale, true) {
        desk.strings = speaking(code);
        desk.now = now;
        desk.view.lecture = true;
        desk.view.settings.watching = true;
        desk.view.settings.selection.vehicle = now.vehicles.front().id;
    }
    std::vector<Rect> starting_with(std::string_view id) const {
        std::vector<Rect> found;
        for (const auto& [name, rect] : desk.anchors.all())
            if (name.starts_with(id)) found.push_back(rect);
        return found;
    }
};

// Every page with a diagram, and scenes with neurons.
template <class Check>
void each_diagram(const Check& check) {
    for (const Size& size : sizes)
        for (const std::string& code : shipped_codes()) {
            const auto of = [&](const std::string& name) {
                return name + " " + code + " at " + std::to_string(size.width) + ", scale " +
                       std::to_string(size.scale);
            };
            for (const char* scene : {"5-logic", "tortoise", "7-mnemotrix"}) {
                SCOPED_TRACE(of(scene));
                Diagram diagram(shipped_scene(scene), size, code);
                diagram.desk.frame(5);
                check(diagram);
            }
            for (const char* lecture : {"four-numbers", "wheels-to-neurons"}) {
                LectureView pages = opened_lecture(lecture);
                for (; pages.page < static_cast<int>(pages.lecture->pages.size()); ++pages.page) {
                    pages.step = static_cast<int>(pages.current().steps.size());
                    if (!pages.shows(PagePart::wiring)) continue;
                    SCOPED_TRACE(of(lecture) + ", page " + std::to_string(pages.page + 1));
                    Diagram diagram(first_moment(pages.current()), size, code);
                    diagram.desk.view.pages = &pages;
                    diagram.desk.frame(5);
                    check(diagram);
                }
            }
        }
}

}  // namespace

TEST(LectureDiagram, NoWeightIsOnANodeOrOnAnotherWeight) {
    int labels = 0;
    each_diagram([&](const Diagram& diagram) {
        const auto weights = diagram.starting_with("wire."), nodes = diagram.starting_with("node.");
        EXPECT_GE(nodes.size(), 4u);
        for (std::size_t i = 0; i < weights.size(); ++i, ++labels) {
            EXPECT_TRUE(is_inside(weights[i], diagram.desk.where("canvas"))) << i;
            for (std::size_t j = 0; j < nodes.size(); ++j) EXPECT_FALSE(overlap(weights[i], nodes[j])) << i << " " << j;
            for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(weights[i], weights[j])) << i << " " << j;
        }
    });
    EXPECT_GT(labels, 100);
}

TEST(LectureDiagram, AWeightIsInsideItsLabel) {
    each_diagram([&](const Diagram& diagram) {
        for (const auto& [name, rect] : diagram.desk.anchors.all())
            if (name.starts_with("weight.")) {
                EXPECT_TRUE(is_inside(rect, diagram.desk.where("wire." + name.substr(7)))) << name;
            }
    });
}

TEST(LectureDiagram, TheButtonsOfThePagesAreInTheBarAndTheTitleGivesWay) {
    each_diagram([&](const Diagram& diagram) {
        EXPECT_EQ(diagram.desk.anchors.find("lecture.next") != nullptr, diagram.desk.view.pages != nullptr);
    });
}

TEST(LectureDiagram, WiresOfObstacleSensorsHaveNoLabels) {
    Diagram diagram(shipped_scene("3b-explorer"), sizes[2], "en");
    Desk& desk = diagram.desk;
    desk.frame(5);
    EXPECT_TRUE(desk.anchors.find("weight.RL"));
    EXPECT_EQ(diagram.starting_with("weight.").size(), 4u);
    EXPECT_TRUE(desk.anchors.find("curve.OL-ML"));
    // Where nothing else is the subject they have labels: the pair of obstacle sensors alone.
    Snapshot& now = desk.now;
    auto scene = std::make_shared<Scene>(*now.scene);
    for (Sensor& sensor : scene->kinds[0].sensors) sensor.channel = Channel::obstacle;
    now.scene = scene;
    desk.frame(5);
    EXPECT_GT(diagram.starting_with("weight.").size(), 4u);
}

TEST(LectureDiagram, AWholeNameIsInsideTheBoxOfItsNode) {
    each_diagram([&](const Diagram& diagram) {
        EXPECT_EQ(diagram.desk.shortened, 0);
        for (const Node& node : diagram.desk.now.brains[0]->nodes)
            EXPECT_TRUE(is_inside(diagram.desk.where("name." + node.name), diagram.desk.where("node." + node.name)))
                << node.name;
    });
}

TEST(LectureDiagram, AMapOfManyNodesHasLargeNamesOfOneHeightAndNamesItsGroups) {
    constexpr float legible = 0.022f, line_by_letters = 1.362f, larger = 1.2f;
    constexpr Size projectors[]{{1024, 768, 1.375f}, {1280, 800, 1.4f}, {1920, 1080, 1.75f}};
    LectureView pages = opened_lecture("wheels-to-neurons");
    pages.page = 12, pages.step = 1;
    for (const Size& size : projectors)
        for (const std::string& code : shipped_codes()) {
            SCOPED_TRACE(code + " at " + std::to_string(size.width));
            Diagram diagram(first_moment(pages.current()), size, code);
            Desk& desk = diagram.desk;
            desk.view.pages = &pages;
            desk.frame(5);
            const std::vector<Node>& nodes = desk.now.brains[0]->nodes;
            ASSERT_GT(nodes.size(), wiring::few_nodes);
            const float first = desk.where("name." + nodes.front().name).h;
            for (const Node& node : nodes) {
                EXPECT_GE(desk.where("name." + node.name).h, larger * legible * line_by_letters * size.height)
                    << node.name;
                EXPECT_NEAR(desk.where("name." + node.name).h, first, 0.1f * first) << node.name;
            }
            EXPECT_EQ(desk.shortened, 0);
            for (const char* group : {"wiring.group.sensors", "wiring.group.neurons", "wiring.group.motors"}) {
                EXPECT_TRUE(is_inside(desk.where(group), desk.where("canvas"))) << group;
                EXPECT_GE(desk.where(group).h, larger * legible * line_by_letters * size.height) << group;
                for (const Rect& node : diagram.starting_with("node."))
                    EXPECT_FALSE(overlap(desk.where(group), node)) << group;
            }
            EXPECT_FALSE(desk.says("≥")) << "a number of one neuron of eight";
            EXPECT_GE(desk.where("viewport").w, 0.25f * size.width) << "the scene is still seen";
        }
}

TEST(LectureDiagram, SaysAtWhichSumANeuronSteps) {
    for (const std::string& code : shipped_codes())
        for (const int page : {10, 11}) {
            LectureView pages = opened_lecture("wheels-to-neurons");
            pages.page = page, pages.step = static_cast<int>(pages.current().steps.size());
            Diagram diagram(first_moment(pages.current()), {1024, 768, 1.4f}, code);
            diagram.desk.view.pages = &pages;
            diagram.desk.frame(5);
            const std::string half = code == "en" ? "≥ 0.50" : "≥ 0,50";
            EXPECT_TRUE(diagram.desk.says(half)) << code << " page " << page + 1;
            EXPECT_TRUE(is_inside(diagram.desk.where("below.N"), diagram.desk.where("canvas")));
        }
}

TEST(LectureDiagram, TheEditorFitsTheBrainAboveTheOpenCardOfANeuronAlsoAfterKeys) {
    for (const auto& [width, height] : {std::pair{1024.0f, 768.0f}, {800.0f, 600.0f}}) {
        Diagram diagram(shipped_scene("5-logic"), {width, height, width > 1000 ? 1.4f : 1.0f}, "en");
        Desk& desk = diagram.desk;
        desk.view.mode = Mode::wiring;
        desk.frame(5);
        for (int i = 0; i < 3; ++i) desk.key({key::right}), desk.frame(2);
        desk.panels.canvas.inspector.folded = false;
        desk.frame(5);
        for (const char* node : {"node.SL", "node.SR", "node.ML", "node.MR"})
            EXPECT_TRUE(is_inside(desk.where(node), desk.where("canvas"))) << node << " at " << width;
    }
}

TEST(LectureDiagram, TheMapOfASmallBrainHasValuesAndSteps) {
    Diagram diagram(shipped_scene("5-logic"), {1024, 768, 1.4f}, "en");
    diagram.desk.frame(5);
    const auto below = diagram.starting_with("below.");
    EXPECT_GE(below.size() + 1, diagram.desk.now.brains[0]->nodes.size()) << "one may have no room";
    EXPECT_TRUE(diagram.desk.says("0.00 (≥ 0.50)"));
    for (std::size_t i = 0; i < below.size(); ++i) {
        for (const Rect& node : diagram.starting_with("node.")) EXPECT_FALSE(overlap(below[i], node));
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(below[i], below[j]));
    }
}

TEST(LectureDiagram, ASensorOfAnotherChannelHasAWordOnTheMap) {
    for (const auto& [code, words] : {std::pair{"en", std::array{"energy", "touch", "place L"}},
                                      {"de", std::array{"Energie", "Kontakt", "Ort L"}},
                                      {"es", std::array{"energía", "tacto", "lugar L"}}}) {
        Diagram diagram(shipped_scene("tortoise"), {1024, 768, 1.4f}, code);
        diagram.desk.frame(5);
        for (const char* word : words) EXPECT_TRUE(diagram.desk.says(word)) << word;
    }
}

TEST(LectureDiagram, NoWordIsOnThePinOfItsMotor) {
    each_diagram([&](const Diagram& diagram) {
        for (const char* motor : {"ML", "MR"}) {
            const Rect node = diagram.desk.where(std::string("node.") + motor);
            const Rect pin = diagram.desk.where("pin." + std::string(motor) + ".in");
            for (const ui::Written& w : diagram.desk.written)
                if (is_inside(w.rect, node)) {
                    EXPECT_GE(w.rect.x, pin.x + pin.w / 2 + 0.3f * pin.w) << w.words;
                }
        }
    });
}

}  // namespace braitenlab::tests::lecture_diagram_test
