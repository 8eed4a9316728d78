#include "app/platform/page.h"

namespace braitenlab {

void repeat(std::function<bool()> turn) {
    while (turn()) {
    }
}

bool is_on_page() { return false; }

void offer_to_page(const std::string&, std::function<std::string()>) {}

}  // namespace braitenlab
