// SPDX-License-Identifier: MIT
// What a script gives a chart to draw.
#pragma once

#include <any>
#include <filesystem>
#include <memory>
#include <variant>
#include <vector>

#include "console/schema/given_value.hpp"
#include "store/recording.hpp"
#include "store/series_file.hpp"

namespace hackle {

class Run;

// The name of a file, a recording, a simulation, which the call keeps alive, or numbers of the
// script.
using ScriptedSource =
    std::variant<std::filesystem::path, std::shared_ptr<Recording>, const Run*, SeriesTable>;
using ScriptedSources = std::vector<ScriptedSource>;

// Reads a list of texts, recordings, simulations, and tables whose members are lists of numbers of
// one length, with a text as `name`.
std::any read_sources(const GivenValue& given);

}  // namespace hackle
