// SPDX-License-Identifier: MIT
#include "output/files/record_options.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/text.hpp"
#include "measure/scalar.hpp"

namespace hackle {
namespace {

// The first of some things in a row and their number: those within `min` to `max`, in units of
// their distance.
struct Span {
  int first, count;
};

Span span_within(double min, double max, double from, int all) {
  const double begin = std::clamp(std::ceil(min - from - 1e-9), 0.0, static_cast<double>(all));
  const double end =
      std::clamp(std::floor(max - from + 1e-9) + 1.0, begin, static_cast<double>(all));
  return {static_cast<int>(begin), static_cast<int>(end - begin)};
}

// Every n-th of them, as many on one side as on the other.
Span thinned(const Span& span, int n) {
  const int count = 1 + (span.count - 1) / n;
  return {span.first + (span.count - 1 - (count - 1) * n) / 2, count};
}

NodeWindow nodes_of(const RecordOptions& options, const Grid& grid) {
  Span along_x{0, grid.nx}, along_y{0, grid.ny};
  if (options.region) {
    const Box box = bounds(*options.region);
    const Vec2 first = grid.position(0, 0);
    along_x =
        span_within(box.min.x() / grid.dx, box.max.x() / grid.dx, first.x() / grid.dx, grid.nx);
    along_y =
        span_within(box.min.y() / grid.dx, box.max.y() / grid.dx, first.y() / grid.dx, grid.ny);
    if (along_x.count < 1 || along_y.count < 1)
      throw Error(ErrorKind::refused, "record: there is no node in its area",
                  "the plate reaches from {0, 0} to {width, height}");
  }
  along_x = thinned(along_x, options.coarsen);
  along_y = thinned(along_y, options.coarsen);
  return {along_x.first, along_y.first, along_x.count, along_y.count, options.coarsen};
}

void check_field(const std::string& field, const Lattice& lattice, Problems& problems) {
  if (std::ranges::find(recordable_fields, field) == recordable_fields.end())
    problems.add(fmt::format("record: there is no field '{}'{}", field,
                             did_you_mean(field, recordable_fields)),
                 "fields: " + comma_list(recordable_fields));
  if (field == fringes_name) check_fringes(lattice);
}

// A part of the nodes has no bonds to be recorded.
void take_bonds_out(const RecordOptions& options, RecordContents& contents, Problems& problems) {
  if (options.exact)
    problems.add("record: exact records hold the state of all nodes",
                 "leave out the area and coarsen, or exact");
  if (std::ranges::find(options.fields, "bonds") != options.fields.end())
    problems.add("record: bonds are only recorded of all nodes",
                 "leave out the area and coarsen, or \"bonds\" in fields");
  std::erase(contents.fields, "bonds");
}

}  // namespace

RecordContents contents_of(const RecordOptions& options, const Lattice& lattice) {
  RecordContents contents = standard_contents(lattice.grid);
  contents.exact = options.exact;
  Problems problems;
  if (!options.fields.empty()) contents.fields.clear();
  for (const std::string& field : options.fields) {
    check_field(field, lattice, problems);
    if (!contents.holds(field)) contents.fields.push_back(field);
  }
  contents.nodes = nodes_of(options, lattice.grid);
  contents.part = contents.nodes.nodes() != lattice.grid.nodes();
  if (contents.part) take_bonds_out(options, contents, problems);
  problems.throw_if_any();
  return contents;
}

double interval_of(const RecordOptions& options, double dt) {
  if (options.every.has_value() == options.steps.has_value())
    throw Error(ErrorKind::refused, "record: when it records is not clear",
                "give every, as in every = 1*us, or steps, as in steps = 100");
  return options.every ? *options.every : *options.steps * dt;
}

}  // namespace hackle
