// SPDX-License-Identifier: MIT
// The data of charts for the present state of a plate.
#pragma once

#include "output/picture/picture.hpp"
#include "render/overlay/chart.hpp"
#include "solver/view.hpp"

namespace hackle {

// Returns the amplitude of every load: the whole curve up to the end of the run, if it is known,
// and past its last point, or the present value of a function of time. If all loads are stresses,
// each uniform on its edge or rim, the curves are stresses; otherwise they are the factors of all
// loads. Only present loads are included: a view does not know earlier ones. Throws what
// Amplitude::at throws.
Chart load_curve(const View& view);

// Returns the present kinetic, strain and broken energy, and the released energy if there is any.
// Visits every bond.
Chart energy_chart(const View& view);

// Throws Error (refused) if the options request something that a single picture does not know: the
// past.
void check_alone(const char* output, const PictureOptions& options);

// Throws Error (refused) if they request something that a recording does not contain: the loads.
void check_recorded(const char* output, const PictureOptions& options);

}  // namespace hackle
