#include "app/reports/svg_file.h"

#include <fmt/format.h>

#include "core/xml_text.h"

namespace braitenlab {

// DejaVu Sans first: CairoSVG takes all signs from one font, and Noto Sans has neither "−" nor "▶".
std::string svg_file(std::string_view heading, float width, float height, std::string_view content) {
    const std::string words = xml_text(heading);
    return fmt::format(
               "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
               "height=\"{1:.0f}\" font-family=\"DejaVu Sans, Noto Sans, sans-serif\">\n<title>{2}</title>\n"
               "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n"
               "<text x=\"20\" y=\"28\" font-size=\"18\" font-weight=\"bold\" fill=\"#1c1c1a\">{2}</text>\n",
               width, height, words) +
           std::string(content) + "\n</svg>\n";
}

}  // namespace braitenlab
