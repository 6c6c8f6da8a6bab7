// SPDX-License-Identifier: MIT
// Finds what the reference says on a word that is no name in it: "restart", "csv", "rayleigh
// speed".
#pragma once

#include <string>
#include <string_view>

namespace hackle {

// Lists, a line each, the functions, options, fields and topics whose name, explanation or other
// words (see search.cpp) have every word of the query, whatever its case. Words are found from
// their beginning on: "wave" finds waves. Returns "" for nothing.
std::string search_reference(std::string_view query);

}  // namespace hackle
