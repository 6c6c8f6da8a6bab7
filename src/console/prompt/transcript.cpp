// SPDX-License-Identifier: MIT
#include "console/prompt/transcript.hpp"

#include <utility>

#include <fmt/format.h>

#include "base/units.hpp"
#include "console/prompt/kept_locals.hpp"

namespace hackle {
namespace {

// Separates a line that begins with a bracket, which would otherwise call the value of the line
// before.
std::string apart(const std::string& text) {
  return fmt::format("{}{}", text.starts_with('(') ? ";" : "", text);
}

std::string as_function(const Transcript::Chunk& chunk) {
  return fmt::format("function(...)\n{}{}\nend", chunk.is_expression ? "return " : "", chunk.text);
}

std::string as_statement(const Transcript::Chunk& chunk) {
  if (chunk.is_statement && !needs_a_scope(chunk.text)) return apart(chunk.text);
  return fmt::format(";({})(...)", as_function(chunk));
}

std::string as_value(const Transcript::Chunk& chunk) {
  return chunk.is_expression ? fmt::format("_ = {}", chunk.text)
                             : fmt::format("_ = ({})(...)", as_function(chunk));
}

std::string commented(std::string text) {
  for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1))
    text.insert(at + 1, "--   ");
  return fmt::format("--   {}", text);
}

}  // namespace

void Transcript::typed(const Chunk& chunk, Outcome outcome) {
  const bool run_is_interrupted = std::exchange(run_is_interrupted_, false);
  if (outcome == Outcome::value) return add(as_value(chunk));
  if (outcome == Outcome::nothing) return add(as_statement(chunk));
  if (outcome == Outcome::interrupted && !run_is_interrupted)
    return add(fmt::format("-- interrupted, and left out:\n{}", commented(chunk.text)));
  add(fmt::format("pcall({}, ...)", as_function(chunk)));
}

void Transcript::went_on(int number, std::int64_t step, double time, bool failed) {
  const std::string wait =
      failed ? fmt::format("pcall(function() simulations()[{}]:wait {{ steps = {} }} end)", number,
                           step)
             : fmt::format("simulations()[{}]:wait {{ steps = {} }}", number, step);
  add(fmt::format("{}  -- {}", wait, quantity(time, "s")));
}

void Transcript::interrupted(int number, std::int64_t step) {
  run_is_interrupted_ = true;
  add(fmt::format("simulations()[{}]:interrupt {{ steps = {} }}", number, step));
}

}  // namespace hackle
