// What the open scene is about.
#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/panels/translated.h"
#include "ui/strings.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

void scene_card(const LabView& view, PanelState& state, Ui& ui, Rect place) {
    place.h = std::min(place.h, wanted_height(ui, state.scene));
    const bool open = begin_card(ui, state.scene, "card.scene", ui.strings("scene.heading"), place);
    if (open) {
        const Scene& scene = *view.now->scene;
        paragraph(ui, scene.title.empty() ? std::string_view(scene.name) : translated(ui, scene.title), ui.palette.text,
                  Face::title);
        if (!scene.story.empty()) paragraph(ui, translated(ui, scene.story), ui.palette.second_text);
    }
    end_card(state.scene);
}

}  // namespace braitenlab
