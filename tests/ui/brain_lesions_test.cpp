// Lesions by the brain card, the wiring editor and the scene: cut wires, covered eyes, silenced neurons.
#include <algorithm>
#include <memory>

#include "brain_on_desk.h"
#include "ui/panels/brain/brain_sketch.h"

namespace braitenlab::tests::brain_lesions_test {

using namespace ui;

TEST(BrainLesions, CoversAndUncoversAnEye) {
    Desk desk(1280, 1000);
    desk.frame(3);
    const BrainGraph before = *desk.now.brains[0];
    desk.click("lesion.SL");
    const BrainGraph covered = brain_asked_for(desk);
    EXPECT_TRUE(find_node(covered, "SL")->silenced);
    EXPECT_FALSE(find_node(covered, "SR")->silenced);
    EXPECT_EQ(read_dials(covered), read_dials(before)) << "the weights are unchanged";
    give(desk, covered);
    desk.click("lesion.SL");
    EXPECT_EQ(brain_asked_for(desk), before);
}

TEST(BrainLesions, StopsAMotor) {
    Desk desk(1280, 1000);
    desk.frame(3);
    desk.click("lesion.MR");
    EXPECT_TRUE(find_node(brain_asked_for(desk), "MR")->silenced);
}

TEST(BrainLesions, CutsAndRestoresAWireByAClick) {
    Desk desk(1280, 1000);
    desk.frame(3);
    const BrainGraph before = *desk.now.brains[0];  // LR and RL
    ASSERT_FALSE(desk.anchors.find("lesion.LL")) << "a missing wire cannot be cut";
    desk.click("lesion.LR");
    const BrainGraph cut = brain_asked_for(desk);
    EXPECT_TRUE(is_cut(cut, "SR", "ML"));
    EXPECT_FALSE(is_cut(cut, "SL", "MR"));
    give(desk, cut);
    desk.click("lesion.LR");
    EXPECT_EQ(brain_asked_for(desk), before);
}

TEST(BrainLesions, AcceptsAClickAnywhereOnAWire) {
    Desk desk(1280, 1000);
    desk.frame(3);
    // A little below the right eye, far from the sign at the end of LR.
    const Rect eye = desk.where("lesion.SR"), end = desk.where("lesion.LR");
    const sketch::WirePath path =
        sketch::path({eye.x + eye.w / 2, eye.y + eye.h / 2 + 9}, {end.x + end.w / 2, end.y + end.h / 2});
    const ImVec2 on{path[0].x - 2, path[0].y + 12};
    ASSERT_LT(sketch::distance(path, on), 6);
    desk.point(on.x, on.y);
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    desk.button(0, false);
    desk.frame(2);
    EXPECT_TRUE(is_cut(brain_asked_for(desk), "SR", "ML"));
}

TEST(BrainLesions, CutsWithTheKeyLUnderThePointerAndWithEnterOnTheFocus) {
    Desk desk(1280, 1000);
    desk.frame(3);
    desk.point("lesion.SR");
    desk.frame(2);
    desk.key({'L'});
    desk.frame();
    EXPECT_TRUE(find_node(brain_asked_for(desk), "SR")->silenced);
    desk.all.clear();
    desk.point(10, 10);
    desk.frame(2);
    desk.key({'L'});
    desk.frame(2);
    EXPECT_TRUE(desk.edits().empty()) << "no part is under the pointer";
    desk.panels.keyboard.focus = "lesion.RL";
    desk.key({key::enter});
    desk.frame();
    EXPECT_TRUE(is_cut(brain_asked_for(desk), "SL", "MR"));
}

TEST(BrainLesions, SilencesANeuronByAClickInItsPicture) {
    Desk desk(1280, 1000);
    desk.now = shipped_scene("5-logic");
    desk.rest();
    const auto& nodes = desk.now.brains[0]->nodes;
    const auto neuron =
        std::find_if(nodes.begin(), nodes.end(), [](const Node& node) { return node.kind == NodeKind::neuron; });
    ASSERT_NE(neuron, nodes.end());
    desk.click("lesion." + neuron->name);
    EXPECT_TRUE(find_node(brain_asked_for(desk), neuron->name)->silenced);
}

TEST(BrainLesions, CutsTheWireOfTheChosenPairAlsoWithoutThePicture) {
    Desk desk(1280, 1000);
    desk.now = shipped_scene("3c-values");
    desk.panels.card(Card::brain).folded = true;
    desk.view.settings.selection.pair = "heat";
    desk.rest();
    desk.panels.brain.lesion_requested = "lesion.LL";
    desk.frame(2);
    ASSERT_EQ(desk.edits().size(), 1u);
    EXPECT_TRUE(is_cut(brain_asked_for(desk), "HL", "ML"));
}

TEST(BrainLesions, NamesTheWiresOfTheOtherPairsByTheirEnds) {
    Desk desk(1280, 1000);
    desk.now = shipped_scene("3c-values");
    desk.view.settings.selection.pair = "heat";
    desk.rest();
    const BrainGraph& brain = *desk.now.brains[0];
    ASSERT_NE(read_dials(brain, {"HL", "HR"}).LL, 0);
    ASSERT_NE(read_dials(brain).LR, 0);
    desk.click("lesion.LL");
    EXPECT_TRUE(is_cut(brain_asked_for(desk), "HL", "ML"));
    desk.all.clear();
    desk.rest();
    desk.click("lesion.SR-ML");
    EXPECT_TRUE(is_cut(brain_asked_for(desk), "SR", "ML"));
}

TEST(BrainLesions, CutsTheWireOfTheChosenPairWithTheKeyLWhileWiring) {
    Desk desk(1280, 1000);
    desk.now = shipped_scene("3c-values");
    desk.view.mode = Mode::wiring;  // without the picture
    desk.view.settings.selection.pair = "heat";
    desk.rest();
    desk.point("slider.LL");
    desk.frame(2);
    desk.key({'L'});
    desk.frame(2);
    EXPECT_TRUE(is_cut(brain_asked_for(desk), "HL", "ML"));
}

TEST(BrainLesions, CutsTheWireOfASliderUnderThePointerWithTheKeyL) {
    Desk desk(1280, 1000);
    desk.panels.brain.thresholds_open = true;
    desk.frame(3);
    for (const char* anchor : {"slider.LR", "threshold.LR"}) {
        desk.all.clear();
        desk.point(anchor);
        desk.frame(2);
        desk.key({'L'});
        desk.frame(2);
        EXPECT_TRUE(is_cut(brain_asked_for(desk), "SR", "ML")) << anchor;
    }
    desk.all.clear();
    desk.point("slider.LL");
    desk.frame(2);
    desk.key({'L'});
    desk.frame(2);
    EXPECT_TRUE(desk.edits().empty()) << "a missing wire cannot be cut";
}

TEST(BrainLesions, SilencesTheEyeOrWheelUnderThePointerInTheSceneWithTheKeyL) {
    Desk desk(1280, 1000);
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    for (Kind& kind : scene->kinds) {
        kind.sensors[0].x = kind.sensors[1].x = 0.3f;
        kind.sensors[0].y = 0.24f, kind.sensors[1].y = -0.24f;
    }
    desk.now.scene = scene;
    const CameraView camera_view = look(Camera{}, Arena{}, nullptr, {0, 0, 1280, 1000}, {336, 64, 576, 880});
    desk.view.camera_view = &camera_view;
    desk.frame(3);
    const auto over = [&](float x, float y) {
        const auto at = *project(camera_view, {x, y}, 0.2f);
        desk.all.clear();
        desk.point(at.x, at.y);
        desk.frame(2);
        desk.key({'L'});
        desk.frame(2);
        return desk.edits().empty() ? BrainGraph{} : brain_asked_for(desk);
    };
    const BrainGraph eye = over(0.3f, 0.24f);  // the selected vehicle is at the origin and faces +x
    ASSERT_TRUE(find_node(eye, "SL"));
    EXPECT_TRUE(find_node(eye, "SL")->silenced);
    const BrainGraph wheel = over(0, -0.3f);
    ASSERT_TRUE(find_node(wheel, "MR"));
    EXPECT_TRUE(find_node(wheel, "MR")->silenced);
    EXPECT_TRUE(over(4, 4).nodes.empty()) << "no lesion on the empty floor";
    desk.now.vehicles[0].heading = 1.5707964f;  // now it faces +y
    desk.frame(2);
    const BrainGraph turned = over(-0.24f, 0.3f);
    ASSERT_TRUE(find_node(turned, "SL"));
    EXPECT_TRUE(find_node(turned, "SL")->silenced);
}

TEST(BrainLesions, HealsAllLesionsInOneStep) {
    Desk desk(1280, 1000);
    desk.frame(3);
    const BrainGraph before = *desk.now.brains[0];
    EXPECT_FALSE(desk.anchors.find("lesion.heal"));
    BrainGraph hurt = before;
    find_node(hurt, "ML")->silenced = true;
    for (Wire& wire : hurt.wires) wire.cut = true;
    give(desk, hurt);
    desk.click("lesion.heal");
    EXPECT_EQ(brain_asked_for(desk), before);
}

}  // namespace braitenlab::tests::brain_lesions_test
