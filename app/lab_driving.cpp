// A vehicle driven by hand.
#include "app/lab_parts.h"
#include "ui/steering.h"

namespace braitenlab {

void drive(Lab& lab) {
    const VehicleView* vehicle = selected_vehicle(lab);
    if (!vehicle) return;
    const Driver kinds = lab.session.snapshot().scene->kinds[static_cast<std::size_t>(vehicle->kind)].driver;
    const Driver others = kinds == Driver::manual ? Driver::brain : kinds;
    apply(lab, ChooseDriver{vehicle->id, vehicle->driver == Driver::manual ? others : Driver::manual});
}

bool steer_by_keys(Lab& lab, float right, float ahead) {
    const VehicleView* vehicle = selected_vehicle(lab);
    const bool drives = vehicle && vehicle->driver == Driver::manual;
    // Whoever was steered and is left to itself lets go of the wheel.
    if (lab.steered.vehicle != no_vehicle && (!drives || vehicle->id != lab.steered.vehicle)) {
        (void)lab.session.apply(steer(lab.steered.vehicle, 0, 0));
        lab.steered = {};
    }
    if (!drives) return false;
    const Steer wanted = steer(vehicle->id, right, ahead);
    const bool idle = right == 0 && ahead == 0;
    if (idle && lab.steered.vehicle == no_vehicle) return true;  // the stick may hold it
    if (wanted != lab.steered) (void)lab.session.apply(wanted);
    lab.steered = idle ? Steer{} : wanted;
    return true;
}

}  // namespace braitenlab
