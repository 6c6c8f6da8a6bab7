// SPDX-License-Identifier: MIT
#include "base/markup.hpp"

namespace hackle {
namespace {

// Puts `before` in front of each character of `special`.
std::string escaped(std::string_view text, std::string_view special, std::string_view before) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) out += before;
    out += c;
  }
  return out;
}

// A line that begins with one of these characters would be a roff command.
std::string guarded(const std::string& line) {
  const bool command = line.starts_with('.') || line.starts_with('\'');
  return command ? "\\&" + line : line;
}

std::string without_backslashes(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '\\' ? std::string("\\e") : std::string(1, c);
  return out;
}

std::string typed(std::string_view text) {
  return guarded(escaped(without_backslashes(text), "-", "\\"));
}

}  // namespace

std::string markdown(std::string_view text) {
  return escaped(text, "\\`*_<>|[]#", "\\");
}

std::string markdown_code(std::string_view text) {
  return text.empty() ? "" : "`" + escaped(text, "|", "\\") + "`";
}

std::string xml(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string from_xml(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    std::size_t taken = 1;
    char c = text.front();
    for (const char plain : {'&', '<', '>', '"'}) {
      const std::string escaped = xml({&plain, 1});
      if (!text.starts_with(escaped)) continue;
      c = plain;
      taken = escaped.size();
    }
    out += c;
    text.remove_prefix(taken);
  }
  return out;
}

std::string roff(std::string_view text) {
  return guarded(without_backslashes(text));
}

std::string roff_code(std::string_view text) {
  return "\\fB" + typed(text) + "\\fR";
}

std::string roff_example(std::string_view lines) {
  std::string text = ".PP\n.RS 4\n.nf\n";
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    text += typed(lines.substr(0, end)) + "\n";
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
  }
  return text + ".fi\n.RE\n";
}

}  // namespace hackle
