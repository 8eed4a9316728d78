// The numbers of one node or wire: its curve as a plot, the curves to choose from, a lesion, and sliders beside
// them.
#pragma once

#include "ui/wiring/inspected.h"

namespace braitenlab {

// One number, and how its slider looks.
struct Number {
    std::string_view id;              // its anchor
    std::string_view words, tooltip;  // string keys
    float low, high, typed_high;      // the slider's range, and how far a typed number may go
    bool is_signed = false;
};

// What the curve answers to, and whether a lesion has silenced or cut it.
struct SheetHead {
    float input;
    bool hurt;
    std::string_view hurt_words;  // string key: what the lesion does
};

// Draws as it is told to, from left to right and in two columns of sliders. What a hand has changed is in the values
// that it was given.
class NumberSheet {
public:
    NumberSheet(Inspected&, Curve&, const SheetHead&);
    ~NumberSheet();
    NumberSheet(const NumberSheet&) = delete;
    NumberSheet& operator=(const NumberSheet&) = delete;

    void number(const Number&, float& value);

    // Peak and width, as far as the curve has them. What the peak is called follows the curve: a step has a threshold;
    // but `masks` says that another slider is called so already.
    void curve_numbers(Curve&, bool masks);

    // Of what was changed; 0 where nothing was.
    std::uint64_t gesture() const { return gesture_; }

private:
    void plot(const Curve&, float input);
    void choose_curve(Curve&, const SheetHead&);
    float room_for_sliders() const;

    Inspected& in_;
    std::uint64_t gesture_ = 0;
    bool plots_;
    float start_, words_width_, slider_width_ = 0;
    int sliders_ = 0;
};

// The height of the card that holds the sheet, layout pixels: a heading, rows of curves and the lesion.
float sheet_height();

// The button that hurts or heals what is selected.
void lesion_button(Inspected&, bool hurt, std::string_view hurt_words);

// What a curve's peak is called: string keys of the word and of what it means.
struct PeakWords {
    std::string_view words, tooltip;
};
PeakWords peak_words(Response, bool masks);

}  // namespace braitenlab
