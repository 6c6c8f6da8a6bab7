// SPDX-License-Identifier: MIT
// What charts show of a simulation at the present moment.
#pragma once

#include "output/picture/picture.hpp"
#include "render/overlay/chart.hpp"
#include "solver/simulation.hpp"

namespace hackle {

// Every amplitude of a load: whole where it is known, up to the end of the run; the present value
// where it is a function of time. Of stresses when there are only such, each the same everywhere on
// its edge or rim; else of the factors of all loads. The loads are those of now: a simulation does
// not know which acted before. Throws what Amplitude::at throws.
Chart load_curve(const Simulation& simulation);

// Kinetic, strain and broken energy now, and what was released where there was any. Visits every
// bond.
Chart energy_chart(const Simulation& simulation);

// Throws Error (refused) when the options ask for what a picture alone does not know: what was
// before it.
void check_alone(const char* output, const PictureOptions& options);

// Throws Error (refused) when they ask for what a recording does not hold: the loads.
void check_recorded(const char* output, const PictureOptions& options);

}  // namespace hackle
