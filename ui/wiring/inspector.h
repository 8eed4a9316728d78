// The card below the canvas with the parameters of the selected neuron or wire.
#pragma once

#include <memory>
#include <optional>

#include <imgui.h>

#include "ui/widgets/slider.h"
#include "ui/wiring/canvas_state.h"

namespace braitenlab::wiring {

// The card's rectangle at the lower end of the canvas's area; lower when it is folded.
Rect inspector_rect(const ui::Ui&, const CanvasState&, Rect canvas);

// Draws the card and sends the user's edits. A direct wire's weight and threshold and a motor's bias are the sliders'
// numbers. Anchors: card.inspector, inspector.weight, .threshold, .bias, .memory, .peak, .width, .learning, .decay,
// .lesion, inspector.kind.<n> for the curves, inspector.column … for several nodes.
void draw_inspector(const LabView&, CanvasState&, ui::SliderState&, ui::Ui&, Rect);

// The selection that the inspector shows, and where its edits go.
struct Inspected {
    const LabView& view;
    const VehicleView& vehicle;
    std::shared_ptr<const BrainGraph> brain;
    CanvasState& state;
    ui::SliderState& sliders;
    ui::Ui& ui;
    Target target;  // vehicle or kind that edits apply to

    const BrainGraph& graph() const { return *brain; }
    std::string_view words(std::string_view key) const;

    // The selected node or wire when it is the only one selected.
    const Node* node() const;
    std::optional<WireEnds> wire() const;

    // In the snapshot.
    float value(NodeId) const;
    float learned_by(const Wire&) const;  // 0 for a wire that does not learn

    void send(Command, std::uint64_t gesture);
    void send(const Edit&, std::uint64_t gesture);  // nothing when refused
};

// A parameter and its slider.
struct Number {
    std::string_view id;              // its anchor
    std::string_view words, tooltip;  // string keys
    float low, high, typed_high;      // the slider's range, and the largest number that can be typed
    bool is_signed = false;
};

struct SheetHead {
    float input;                    // of the curve now
    bool lesioned;                  // silenced or cut
    std::string_view lesion_words;  // string key of what the lesion does
};

// Draws from left to right, the sliders in two columns. The user's changes are written to the values passed to it.
class NumberSheet {
public:
    NumberSheet(Inspected&, Curve&, const SheetHead&);
    ~NumberSheet();
    NumberSheet(const NumberSheet&) = delete;
    NumberSheet& operator=(const NumberSheet&) = delete;

    void number(const Number&, float& value);

    // Peak and width, where the curve has them. `has_threshold`: another slider is called threshold already.
    void curve_numbers(Curve&, bool has_threshold);

    // Of the change; 0 without one.
    std::uint64_t gesture() const { return gesture_; }

private:
    void plot(const Curve&, float input);
    void choose_curve(Curve&, const SheetHead&);

    Inspected& in_;
    std::uint64_t gesture_ = 0;
    bool plots_, in_one_column_ = false;
    float words_width_, slider_width_ = 0;
    int sliders_ = 0;
};

// The height of a card with a sheet whose content is `width` wide: all numbers of a straight wire are in sight. Window
// pixels.
float sheet_height(const ui::Ui&, float width);

// The button that lesions or heals the selection.
void lesion_button(Inspected&, bool lesioned, std::string_view lesion_words);

// A curve without axes, for a row or a button.
void draw_curve(ImDrawList&, const ui::Ui&, Rect, const Curve&, Colour);

}  // namespace braitenlab::wiring
