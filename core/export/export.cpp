#include "core/export/export.h"

#include <fmt/format.h>

namespace braitenlab::robots {

Result<std::vector<ExportedFile>> export_brain(const BrainToExport& given, Target target, const Robot& robot) {
    const auto plan = make_plan(given, static_cast<float>(robot.rate_hz));
    if (!plan) return plan.error();
    switch (target) {
        case Target::c:
            return std::vector<ExportedFile>{{"brain.h", c_header(*plan)}};
    }
    return Error{"unknown target"};
}

}  // namespace braitenlab::robots
