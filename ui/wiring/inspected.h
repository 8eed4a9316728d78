// What the card below the canvas shows the numbers of, and how it asks for others.
#pragma once

#include "ui/widgets/slider.h"
#include "ui/wiring/canvas.h"

namespace braitenlab {

struct Inspected {
    const LabView& view;
    const VehicleView& vehicle;
    std::shared_ptr<const BrainGraph> brain;
    CanvasState& state;
    SliderState& sliders;
    Ui& ui;
    Target target;  // whom edits go to

    const BrainGraph& graph() const { return *brain; }
    std::string_view words(std::string_view key) const;

    // The one node or the one wire that is selected; none where nothing or more is.
    const Node* node() const;
    std::optional<WireEnds> wire() const;

    // What stands there at this moment.
    float value(NodeId) const;
    float learned_by(const Wire&) const;  // 0 for a wire that learns nothing

    void ask(Command, std::uint64_t gesture);
    void ask(const Edit&, std::uint64_t gesture);  // nothing where it was refused
};

// The node's numbers: its curve, bias and memory. Precondition: no sensor.
void inspect_node(Inspected&, const Node&);

// The wire's numbers, or those of a free place, which becomes a wire when it is given any.
void inspect_wire(Inspected&, WireEnds);

}  // namespace braitenlab
