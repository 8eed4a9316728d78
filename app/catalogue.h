// What can be opened from the menu.
#pragma once

#include <vector>

#include "ui/lab_view.h"

namespace braitenlab {

// What ships and can be read; a broken file is left out here and says why when it is opened by name.
std::vector<CatalogueEntry> read_catalogue();

}  // namespace braitenlab
