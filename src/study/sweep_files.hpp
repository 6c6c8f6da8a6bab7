// SPDX-License-Identifier: MIT
// What a sweep leaves behind: a table, charts, a contact sheet, a film over the parameter.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "render/diagram/diagram.hpp"
#include "study/study_files.hpp"
#include "study/sweep.hpp"

namespace hackle {

// A chart of each quantity that is a number, over the parameter, if a single one varies and is a
// number.
std::vector<Diagram> charts_of(const Sweep& sweep);

// All of it; charts are named sweep-fork.time. The table for a person is as wide as `columns`, 0:
// as it needs.
StudyFindings findings_of(const Sweep& sweep, std::size_t columns);

// Writes the last pictures of all runs that have one, with their settings, on a sheet: a row per
// value of the first parameter where two vary. Throws Error (refused) if there is none, and what
// contact_sheet throws.
void write_sheet(const CaseRunner& runner, const Sweep& sweep, const std::filesystem::path& path);

// Writes them as a film, a frame per run. Throws Error (refused) if there is none, if they differ
// in size, or if more than one parameter varies, and what films throw.
void write_film(const CaseRunner& runner, const Sweep& sweep, const std::filesystem::path& path);

}  // namespace hackle
