// SPDX-License-Identifier: MIT
// An ensemble for people and programs: text, table, JSON, chart.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "render/diagram/diagram.hpp"
#include "study/ensemble.hpp"
#include "study/table.hpp"

namespace hackle {

// Says in a few sentences until when the runs agree, and which numbers hold for a single one.
std::string verdict_of(const Ensemble& ensemble);

// The verdict, and of each quantity that any run found mean, half its 95 % interval, deviation and
// range.
std::string text_of(const Ensemble& ensemble);

// The numbers of each run, in SI.
Table table_of(const Ensemble& ensemble);

// {"schema":1,"kind":"ensemble","runs":32,"agree_until_s":..,"agree_within_m":..,"quantities":
// {"branches":{"mean":..,"sd":..,"low":..,"high":..,"min":..,"max":..},..}}, see
// src/study/README.md.
nlohmann::ordered_json to_json(const Ensemble& ensemble);

// How far the runs are from the first over time.
Diagram chart_of(const Ensemble& ensemble);

}  // namespace hackle
