// SPDX-License-Identifier: MIT
// What hackle validate found, as a page for a browser and as tables for Markdown.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "app/validation.hpp"

namespace hackle {

// Returns one HTML file with its pictures and charts in it. Throws Error (files) if a picture
// cannot be read.
std::string validation_page(std::span<const Validated> all, bool quick);

// Returns a row for each check.
std::string markdown_table(std::span<const Validated> all);
// Returns a row for each script: how many of its checks pass.
std::string markdown_summary(std::span<const Validated> all);

// Replaces what stands between the lines "<!-- hackle validate: NAME -->" and "<!-- end -->" in a
// text, where NAME is `table` or `summary`. Throws Error (files), naming `file`, if there is no
// such place.
std::string with_tables(std::string text, std::span<const Validated> all,
                        const std::filesystem::path& file);

}  // namespace hackle
