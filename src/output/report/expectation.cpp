// SPDX-License-Identifier: MIT
#include "output/report/expectation.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/units.hpp"

namespace hackle {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

double low(const Expectation& e) {
  return e.expected ? *e.expected - e.tolerance : e.min;
}

double high(const Expectation& e) {
  return e.expected ? *e.expected + e.tolerance : e.max;
}

Json to_json(const ExpectedCurve& curve) {
  return {{"along", curve.along}, {"x", curve.x}, {"expected", curve.expected}, {"got", curve.got}};
}

std::string said(const Expectation& e) {
  const std::string tolerance = tolerance_text(e);
  if (tolerance.empty() || !e.got) return expected_text(e);
  return fmt::format("{}{}{}", expected_text(e), tolerance == "exact" ? ", " : " within ",
                     tolerance);
}

}  // namespace

Verdict Expectation::verdict() const {
  if (unsupported) return Verdict::unsupported;
  return got && *got >= low(*this) && *got <= high(*this) ? Verdict::pass : Verdict::fail;
}

std::optional<double> Expectation::deviation() const {
  const double half = 0.5 * (high(*this) - low(*this));
  if (!got || !std::isfinite(half) || half <= 0.0) return std::nullopt;
  return (*got - 0.5 * (high(*this) + low(*this))) / half;
}

std::string expected_text(const Expectation& e) {
  if (e.expected) return quantity(*e.expected, e.unit);
  const bool has_min = std::isfinite(e.min), has_max = std::isfinite(e.max);
  if (has_min && has_max)
    return fmt::format("{} to {}", quantity(e.min, e.unit), quantity(e.max, e.unit));
  if (has_min) return "at least " + quantity(e.min, e.unit);
  return has_max ? "at most " + quantity(e.max, e.unit) : "";
}

std::string tolerance_text(const Expectation& e) {
  if (!e.expected) return "";
  if (e.relative > 0.0) return quantity(100.0 * e.relative, "%");
  return e.tolerance > 0.0 ? quantity(e.tolerance, e.unit) : "exact";
}

std::string got_text(const Expectation& e) {
  if (e.unsupported && !e.got) return "";
  return e.got ? quantity(*e.got, e.unit) : "nothing";
}

std::string source_text(const Expectation& e) {
  return e.confirmed ? e.source : e.source + " (unconfirmed)";
}

std::string line_of(const Expectation& e) {
  std::string line = fmt::format("{:<4}  {}", name_of(e.verdict()), e.quantity);
  if (!e.unsupported) line += fmt::format(": {}, expected {}", got_text(e), said(e));
  line += fmt::format(" ({})", source_text(e));
  const bool explains = e.verdict() != Verdict::pass && !e.reason.empty();
  return explains ? fmt::format("{}: {}", line, e.reason) : line;
}

Json to_json(const Expectation& e) {
  Json json{{"name", e.name},
            {"quantity", e.quantity},
            {"unit", e.unit},
            {"expected", number_or_null(e.expected)},
            {"source", e.source},
            {"got", number_or_null(e.got)},
            {"tolerance", e.expected ? Json(e.tolerance) : Json()},
            {"verdict", name_of(e.verdict())},
            {"min", number_or_null(low(e))},
            {"max", number_or_null(high(e))},
            {"confirmed", e.confirmed},
            {"reason", e.reason}};
  if (!e.curve.x.empty()) json["curve"] = to_json(e.curve);
  return json;
}

}  // namespace hackle
