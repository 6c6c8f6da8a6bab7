// SPDX-License-Identifier: MIT
#include "study/envelope_cells.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"

namespace hackle {
namespace {

constexpr auto families = std::to_array<EnvelopeFamily>({
    {"step", "steps from 0.2 to 1.2 of the limit, m from 2 to 16"},
    {"method", "horizons of 2 to 16 spacings, and every way to weigh and calibrate bonds"},
    {"nodes", "1 x 1, 1 x N, N x 1, up to 20 million nodes"},
    {"scale", "nanometres to kilometres, E 1e-3 to 1e15 Pa, rho 1e-6 to 1e8 kg/m3"},
    {"toughness", "G0 from 1e-12 to 1e12 J/m2"},
    {"stress", "loads from 1e-12 to 1e6 of the strength"},
    {"speed", "flight from a billionth of the speed of waves to ten times that"},
    {"parting", "halves that fly apart or into each other, up to twice the speed of waves"},
    {"alpha", "toughening by compression from 0 to 1"},
    {"scatter", "scatter of the strength up to 100 %"},
    {"damping", "damping rates from 0 to 1e12"},
    {"heat", "temperature changes from -1e4 to 1e4 K"},
    {"shatter", "everything broken in one step, single nodes flying"},
    {"still", "nothing ever loaded"},
    {"compression", "compression up to 90 %"},
    {"spin", "spin, for up to 1e5 turns"},
    {"ringing", "ringing, for up to 1e7 steps in f32 and f64"},
    {"load", "kinks, spikes, and functions that return no numbers"},
    {"impact", "impacts from a crawl to above the speed of waves, of light and heavy bodies"},
    {"foundation", "elastic foundations from soft to rigid"},
    {"crack", "cracks of no length, through everything, and thousands of them"},
    {"overflow", "numbers near the ends of f32 and f64"},
    {"nonsense", "numbers that make no sense"},
});

enum class Weight { light, heavy };

// Cells of one family with one demand; see expanded() for the words.
struct CellRow {
  std::string_view family;
  std::string_view words;
  Demand demand = Demand::right;
  Weight weight = Weight::light;
};

using enum Demand;

constexpr auto rows = std::to_array<CellRow>({
    {"step", "m=2|3|4|8|16 share=0.2|0.4|0.6|0.8|0.9|0.95|0.99"},
    {"step", "precision=f32 m=2|4|8 share=0.2|0.6|0.9|0.99"},
    {"step", "m=4|16 share=1|1.001|1.01", any},
    {"step", "m=2|4|8|16 share=1.05|1.1|1.2", stopped},
    {"step", "precision=f32 share=1.05|1.2", stopped},
    {"step", "force=false share=1.001|1.2", refused},

    {"method", "m=2|2.5|3|3.015|4|5|6|8|10|12|14|16"},
    {"method", "precision=f32 m=2|3|4|8|16"},
    {"method",
     "quadrature=full|ramp|area|centroid micromodulus=constant|conical surface=none|energy"},
    {"method", "constants=continuum|paper surface=volume|none"},
    {"method", "plane=strain precision=f64|f32"},
    {"method", "fidelity=0.01|0.5|1"},
    {"method", "fused=true precision=f64|f32"},
    {"method", "m=1|1.99|16.01|1e9|0/0", refused},

    {"nodes", "precision=f64|f32 nx=1|2|3 ny=1|2"},
    {"nodes", "nx=1|1000 ny=1|37"},
    {"nodes", "m=2|16 nx=1|2 ny=1|1000"},
    {"nodes", "steps=10 nx=1 ny=100000"},
    {"nodes", "steps=10 nx=100000 ny=2"},
    {"nodes", "steps=4 nx=1000 ny=1000 precision=f64"},
    {"nodes", "steps=3 nx=5000 ny=4000 precision=f32", right, Weight::heavy},
    {"nodes", "nx=1e6|1e9|1e15 ny=1e6", refused},

    {"scale", "dx=1e-9|1e-8|1e-7|1e-6|1e-5|1e-4|1e-2|1e-1|1|10|16.7"},
    {"scale", "E=1e-3|1|1e3|1e6|1e9|1e11|1e12|1e15"},
    {"scale", "rho=1e-6|1e-4|1e-2|1|1e2|1e4|1e6|1e8"},
    {"scale", "precision=f32 dx=1e-9|1e-6|1|16.7"},
    {"scale", "precision=f32 E=1e-3|1e15"},
    {"scale", "precision=f32 rho=1e-6|1e8"},
    {"scale", "dx=1e-9|16.7 E=1e-3|1e15 rho=1e-6|1e8"},
    {"scale", "alpha=0.25 dx=1e-9|16.7"},

    {"toughness",
     "G0=1e-12|1e-10|1e-8|1e-6|1e-4|1e-2|1|1e2|1e3|1e4|1e5|1e6|1e7|1e8|1e9|1e10|1e11|1e12"},
    {"toughness", "precision=f32 G0=1e-12|1e-6|1|1e6|1e12"},

    {"stress", "load=1e-12|1e-11|1e-10|1e-8|1e-6|1e-5|1e-4|1e-3|1e-2|0.1|0.3|1|3|10|100|1e3|1e4"},
    {"stress", "load=1e5|1e6", any},
    {"stress", "precision=f32 load=1e-12|1e-6|1e-3|1|1e3"},
    {"stress", "precision=f32 load=1e6", any},
    {"stress", "alpha=0.5 load=1e-6|1|100"},

    {"speed", "share=1e-9|1e-6|1e-3|0.1|0.5|0.9|1|1.1|2|10"},
    {"speed", "precision=f32 share=1e-9|1e-3|0.5|1|2|10"},
    {"speed", "nx=1 ny=1 steps=100000 share=1|10 precision=f64|f32"},

    {"parting", "share=0.001|0.01|0.1|0.5|1|2 precision=f64|f32"},
    {"parting", "share=-0.001|-0.01|-0.1|-1|-2 precision=f64|f32"},
    {"parting", "contact=true share=-0.01|-0.1|-1|-2|1"},

    {"alpha", "alpha=0|1e-12|0.02|0.25|0.5|0.75|0.9|0.99|0.999999"},
    {"alpha", "precision=f32 alpha=0.02|0.25|0.99"},
    {"alpha", "alpha=1|2|-0.1|0/0", refused},

    {"scatter", "modulus=1 spread=1 precision=f64|f32"},
    {"scatter", "modulus=2 spread=0.53"},
    {"scatter", "modulus=10|100|1000 spread=0.13"},
    {"scatter", "deviation=1e-6|0.05|0.1|0.2|0.3 spread=0.3"},
    {"scatter", "modulus=1|10 correlation=1e-3|10e-3|1"},
    {"scatter", "modulus=0|0.5|-1|0/0", refused},
    {"scatter", "deviation=0.31|1|-1|0/0", refused},

    {"damping", "rate=0|1e-12|1e-3|1|1e3|1e4|1e5|1e6|1e7|1e8|1e9|1e10|1e12"},
    {"damping", "precision=f32 rate=1|1e5|1e8|1e12"},
    {"damping", "stiffness=1e-12|1e-9|1e-8|1e-7"},
    {"damping", "stiffness=1e-3|1|1e12 steps=20", any},
    {"damping", "rate=-1|0/0|1/0", refused},

    {"heat", "change=-1e4|-1e3|-100|-1e-6|0|1e-6|100|1e3|1e4"},
    {"heat", "way=\"at once\"|ramp change=-1e4|-100|100|1e4 s0=0.5|1e-3"},
    {"heat", "precision=f32 way=ramp change=-1e4|-100|100|1e4"},
    {"heat", "alphaT=1e-4|1e-2|1 change=-1e4|1e4", refused},

    {"shatter", "m=2|4|16 precision=f64|f32"},
    {"shatter", "growth=0.01|0.1|10|100 precision=f64|f32"},
    {"shatter", "alpha=0.5|0.99"},
    {"shatter", "contact=true growth=1|10"},
    {"shatter", "steps=10000 precision=f64|f32"},

    {"still", "precision=f64|f32 m=2|4|16"},
    {"still", "alpha=0.5 contact=true hole=true scatter=true damping=1e12 precision=f64|f32"},
    {"still", "cracks=1|100 surface=none|energy"},

    {"compression", "share=0.1|0.3|0.5|0.6|0.7|0.8|0.9|0.95 precision=f64|f32"},
    {"compression", "G0=200 share=0.1|0.5|0.9"},
    {"compression", "safety=0.9 share=0.5|0.9"},
    {"compression", "contact=true G0=200|2e10 share=0.1|0.5|0.9"},
    {"compression", "driven=true share=0.1|0.3|0.5|0.7|0.9 precision=f64|f32"},

    {"spin", "share=1e-6|1e-3|0.005|0.015|0.1|0.3|1|2 precision=f64|f32"},
    {"spin", "n=2 m=2 s0=0.9 share=0.1|0.3 turns=100|1e4 precision=f64|f32"},
    {"spin", "n=6 s0=0.9 share=0.1 turns=100"},
    {"spin", "n=2 m=2 s0=0.9 share=0.3 turns=1e5 precision=f64|f32", right, Weight::heavy},

    {"ringing", "steps=10000|100000 precision=f64|f32"},
    {"ringing", "m=4|6 steps=100000"},
    {"ringing", "steps=1e7 precision=f64|f32", right, Weight::heavy},

    {"load",
     "amplitude=kink|spike|giant_spike|jump|ramp|short_ramp|long_ramp|pulse|short_pulse|late|step|"
     "twice|sine|fast_sine|noise|huge|tiny"},
    {"load", "precision=f32 amplitude=kink|spike|huge|tiny|fast_sine"},
    {"load", "amplitude=giant_spike|constant|huge steps=400", any},
    {"load",
     "amplitude=nan|nan_later|inf|inf_later|text|nothing|nothing_later|table|error|error_later|"
     "unordered|empty|nan_point|nan_time|endless|endless_later",
     unlike},

    {"impact", "v=1e-3|0.1|1|10|100|500 precision=f64|f32"},
    {"impact", "v=3000|6000|20000|1e5", any},
    {"impact", "density=5e3|1e6|1e12 v=10"},
    {"impact", "density=1e-3|1 v=10", refused},
    {"impact", "friction=10 restitution=0|0.5|1"},

    {"foundation", "stiffness=1e-12|1e-3|1|1e6|1e9|1e12|1e15|1e16|1e18|1e20|1e25|1e30"},
    {"foundation", "precision=f32 stiffness=1e-12|1e12|1e16|1e20"},
    {"foundation", "stiffness=0|-1|0/0|1/0", refused},

    {"crack", "kind=none|through|diagonal|short|on_nodes|grid|around born=broken|absent"},
    {"crack", "kind=random count=1|100|10000 precision=f64|f32"},
    {"crack", "kind=point|outside", refused},
    {"crack", "m=2|16 kind=grid|random"},

    {"overflow", "E=1e-20|1e20|1e30|1e100 precision=f32|f64"},
    {"overflow", "E=1e-300|1e-100 precision=f32|f64", stopped},
    {"overflow", "precision=f64 E=1e-30"},
    {"overflow", "precision=f32 E=1e-30", stopped},
    {"overflow", "E=1e300 precision=f32|f64", refused},
    {"overflow", "rho=1e-30|1e30|1e100|1e300 precision=f32|f64"},
    {"overflow", "rho=1e-100 precision=f32|f64", stopped},
    {"overflow", "rho=1e-300 precision=f32|f64", refused},
    {"overflow", "G0=1e-300|1e-100|1e-30|1e30|1e100 precision=f32|f64"},
    {"overflow", "G0=1e300 precision=f32|f64", refused},
    {"overflow", "dx=1e-30|1e30 precision=f32|f64"},
    {"overflow", "dx=1e-300|1e-100|1e100|1e300 precision=f32|f64", refused},
    {"overflow", "stress=1e-300|1e-45|1e-30|1e20|1e30 precision=f32|f64"},
    {"overflow", "stress=1e100|1e300 precision=f32|f64", stopped},
    {"overflow", "v=1e-300|1e-30|1e10|1e30 precision=f32|f64"},
    {"overflow", "v=1e100|1e300 precision=f32|f64", stopped},
    {"overflow", "u=1e-300|1e-30|1e3|1e10|1e30 precision=f32|f64"},
    {"overflow", "u=1e100|1e300 precision=f32|f64", stopped},
    {"overflow", "alphaT=1e-300|1e-30 change=1e-300"},
    {"overflow", "alphaT=1e-300|1e-30 change=1e300", refused},
    {"overflow", "alphaT=1e300 change=1e-300|1e300", refused},

    {"nonsense",
     "what=width|height|spacing|horizon|E|rho|nu|G0|alpha|alphaT|stress|rate|change|v|step|"
     "fidelity|"
     "safety|duration|stiffness value=0/0|1/0",
     refused},
    {"nonsense",
     "what=width|height|spacing|horizon|E|rho|nu|G0|alpha|alphaT|rate|step|fidelity|safety|"
     "duration|"
     "stiffness value=-1",
     refused},
    {"nonsense", "what=width|height|spacing|horizon|E|rho|G0|step|safety|stiffness value=0",
     refused},
});

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(at), text.size());
    if (end > 0) parts.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

// As split at blanks, but not within quotation marks.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words(1);
  bool quoted = false;
  for (const char letter : text) {
    if (letter == '"')
      quoted = !quoted;
    else if (letter == ' ' && !quoted)
      words.emplace_back();
    else
      words.back() += letter;
  }
  return words;
}

std::vector<EnvelopeCell> cells_of(const CellRow& row) {
  constexpr std::size_t every = 6;
  std::vector<EnvelopeCell> cells = expanded(row.family, row.words);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    cells[k].demand = row.demand;
    cells[k].heavy = row.weight == Weight::heavy;
    cells[k].quick = !cells[k].heavy && (k % every == 0 || k + 1 == cells.size());
  }
  return cells;
}

void check_families(const std::vector<std::string>& names) {
  std::vector<std::string_view> known;
  known.reserve(families.size());
  for (const EnvelopeFamily& family : families) known.push_back(family.name);
  Problems problems;
  for (const std::string& name : names)
    if (std::ranges::find(known, name) == known.end())
      problems.add(fmt::format("there is no family '{}'{}", name, did_you_mean(name, known)),
                   "there are " + comma_list(known));
  problems.throw_if_any(ErrorKind::usage);
}

}  // namespace

std::span<const EnvelopeFamily> envelope_families() {
  return families;
}

std::vector<EnvelopeCell> expanded(std::string_view family, std::string_view words) {
  std::vector<EnvelopeCell> cells(1);
  cells.front().family = family;
  for (const std::string& word : words_of(words)) {
    const std::size_t equals = word.find('=');
    const std::string key = word.substr(0, equals);
    std::vector<EnvelopeCell> more;
    for (const EnvelopeCell& cell : cells)
      for (const std::string& value : split(word.substr(equals + 1), '|')) {
        more.push_back(cell);
        more.back().settings[key] = value;
        more.back().name += fmt::format("{}{}={}", cell.name.empty() ? "" : " ", key, value);
      }
    cells = std::move(more);
  }
  return cells;
}

std::vector<EnvelopeCell> envelope_cells(const std::vector<std::string>& names, bool quick) {
  check_families(names);
  std::vector<EnvelopeCell> all;
  for (const EnvelopeFamily& family : families) {
    if (!names.empty() && std::ranges::find(names, family.name) == names.end()) continue;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (rows[row].family != family.name) continue;
      for (EnvelopeCell& cell : cells_of(rows[row])) {
        cell.row = static_cast<int>(row);
        if (!quick || cell.quick) all.push_back(std::move(cell));
      }
    }
  }
  return all;
}

}  // namespace hackle
