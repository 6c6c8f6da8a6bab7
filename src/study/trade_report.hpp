// SPDX-License-Identifier: MIT
// A trade for people and programs: text, table, JSON, chart.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "render/diagram/diagram.hpp"
#include "study/table.hpp"
#include "study/trade.hpp"

namespace hackle {

// The front with its errors, what is recommended for each budget, and what chance alone moves.
std::string text_of(const Trade& trade);

// Every run with every error, in SI.
Table table_of(const Trade& trade);

// {"schema":1,"kind":"trade","reference":{},"runs":[..],"recommended":[..]}, see
// src/study/README.md.
nlohmann::ordered_json to_json(const Trade& trade);

// Error against CPU time, both logarithmic, with the front named.
Diagram chart_of(const Trade& trade);

}  // namespace hackle
