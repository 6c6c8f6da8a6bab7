// SPDX-License-Identifier: MIT
#include "app/validation_page.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "app/validation_chart.hpp"
#include "base/error.hpp"
#include "base/files.hpp"
#include "base/machine.hpp"
#include "base/markup.hpp"
#include "base/version.hpp"

namespace hackle {
namespace {

constexpr std::string_view style = R"(
:root { --ground:#ffffff; --panel:#f5f7f9; --ink:#1c2733; --faint:#64717f; --rule:#dfe5ea; --pass:#1f8a5b;
  --fail:#c8372d; --unsupported:#8b7355; --line:#2467a8; --good:#cfe8dc; --dot:#d9662a; }
@media (prefers-color-scheme: dark) { :root { --ground:#12181f; --panel:#1a222b; --ink:#e4e9ee; --faint:#93a1af;
  --rule:#2c3742; --pass:#4cc38a; --fail:#ff7a70; --unsupported:#c9ae8c; --line:#6bb0f0; --good:#20503a; --dot:#ffa060; } }
* { box-sizing:border-box; }
body { margin:0; background:var(--ground); color:var(--ink); font:15px/1.5 system-ui, "Segoe UI", Roboto, sans-serif; }
main { max-width:1120px; margin:0 auto; padding:40px 24px 80px; }
h1 { font-size:30px; margin:0 0 4px; letter-spacing:-0.01em; }
h2 { font-size:19px; margin:0; }
p { margin:4px 0; }
a { color:var(--line); text-decoration:none; } a:hover { text-decoration:underline; }
.faint { color:var(--faint); font-size:13px; }
.counts { display:flex; flex-wrap:wrap; gap:12px; margin:24px 0 10px; }
.count { background:var(--panel); border:1px solid var(--rule); border-radius:10px; padding:12px 20px; min-width:130px; }
.count b { display:block; font-size:28px; line-height:1.2; }
.share { display:flex; height:8px; border-radius:4px; overflow:hidden; margin:0 0 28px; background:var(--rule); }
.share i.pass { background:var(--pass); } .share i.fail { background:var(--fail); }
.share i.unsupported { background:var(--unsupported); }
nav { columns:3 240px; margin:0 0 36px; font-size:14px; }
nav a { display:block; color:var(--ink); padding:1px 0; } nav a i { font-style:normal; margin-right:8px; }
section { border-top:1px solid var(--rule); padding:24px 0 30px; }
table { border-collapse:collapse; width:100%; margin:14px 0 4px; font-size:14px; }
th { text-align:left; font-weight:600; color:var(--faint); font-size:12px; padding:4px 10px 4px 0; border-bottom:1px solid var(--rule); }
td { padding:7px 10px 7px 0; border-bottom:1px solid var(--rule); vertical-align:top; }
td.number { white-space:nowrap; font-variant-numeric:tabular-nums; }
tr:last-child td { border-bottom:0; }
.reason { color:var(--faint); font-size:13px; }
b.pass, i.pass { color:var(--pass); } b.fail, i.fail { color:var(--fail); } b.unsupported, i.unsupported { color:var(--unsupported); }
mark { background:none; color:var(--unsupported); border:1px solid var(--unsupported); border-radius:4px; font-size:11px; padding:0 4px; }
.figures { display:flex; flex-wrap:wrap; gap:16px; margin-top:16px; align-items:flex-start; }
.figures img { max-width:100%; width:520px; border-radius:8px; }
.figures.many img { width:250px; }
svg.chart { width:420px; max-width:100%; background:var(--panel); border-radius:8px; }
svg .label { fill:var(--faint); font-size:12px; } svg .grid { stroke:var(--rule); stroke-width:1; }
svg .line { fill:none; stroke:var(--line); stroke-width:2; } svg .dot { fill:none; stroke:var(--dot); stroke-width:1.8; }
svg.bar .all { fill:var(--rule); } svg.bar .good { fill:var(--good); }
svg.bar .pass { fill:var(--pass); } svg.bar .fail { fill:var(--fail); }
)";

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (k < count ? static_cast<unsigned char>(bytes[at + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? letters[group >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

std::size_t checks_of(std::span<const Validated> all) {
  std::size_t sum = 0;
  for (const Validated& one : all) sum += one.checks.size();
  return sum;
}

std::string plural(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

constexpr std::array verdicts{Verdict::pass, Verdict::fail, Verdict::unsupported};

std::string counts_of(std::span<const Validated> all) {
  std::string html = "<div class=\"counts\">";
  std::string share = "<div class=\"share\">";
  for (const Verdict verdict : verdicts) {
    const std::size_t number = count(all, verdict);
    html += fmt::format(R"(<div class="count"><b class="{0}">{1}</b>{0}</div>)", name_of(verdict),
                        number);
    share += fmt::format(R"(<i class="{}" style="flex:{}"></i>)", name_of(verdict), number);
  }
  return html + "</div>" + share + "</div>";
}

// The worst verdict of a script.
Verdict verdict_of(const Validated& one) {
  const auto has = [&](Verdict verdict) { return count({&one, 1}, verdict) > 0; };
  if (has(Verdict::fail)) return Verdict::fail;
  return has(Verdict::pass) ? Verdict::pass : Verdict::unsupported;
}

std::string contents_of(std::span<const Validated> all) {
  std::string html = "<nav>";
  for (const Validated& one : all)
    html += fmt::format(R"(<a href="#{0}"><i class="{1}">&#9679;</i>{2}</a>)", xml(one.script.name),
                        name_of(verdict_of(one)), xml(one.script.name));
  return html + "</nav>";
}

std::string cell(std::string_view text) {
  return fmt::format("<td class=\"number\">{}</td>", xml(text));
}

std::string row_of(const Expectation& e) {
  std::string quantity = xml(e.quantity);
  if (e.verdict() != Verdict::pass && !e.reason.empty())
    quantity += fmt::format("<div class=\"reason\">{}</div>", xml(e.reason));
  const std::string source =
      xml(e.source) + (e.confirmed ? "" : " <mark title=\"nobody has read it\">unconfirmed</mark>");
  return fmt::format(
      "<tr><td>{}</td>{}{}{}<td>{}</td><td>{}</td><td><b class=\"{}\">{}</b></td></tr>\n", quantity,
      cell(expected_text(e)), cell(tolerance_text(e)), cell(got_text(e)), bounds_chart(e), source,
      name_of(e.verdict()), name_of(e.verdict()));
}

std::string figures_of(const Validated& one) {
  std::string html;
  for (const std::filesystem::path& picture : one.pictures)
    html += fmt::format(R"(<img alt="{}" src="data:image/png;base64,{}">)",
                        xml(picture.stem().string()), base64(read_text(picture)));
  for (const Expectation& e : one.checks)
    if (!e.curve.got.empty()) html += curve_chart(e);
  if (html.empty()) return "";
  return fmt::format("<div class=\"figures{}\">{}</div>", one.pictures.size() > 1 ? " many" : "",
                     html);
}

std::string section_of(const Validated& one) {
  std::string html =
      fmt::format("<section id=\"{}\"><h2>{}</h2><p class=\"faint\">{} &middot; {:.1f} s</p>\n",
                  xml(one.script.name), xml(one.title.empty() ? one.script.name : one.title),
                  xml(one.place), one.seconds);
  html +=
      "<table><tr><th>quantity</th><th>expected</th><th>within</th><th>got</th><th></th>"
      "<th>source</th><th>verdict</th></tr>\n";
  for (const Expectation& e : one.checks) html += row_of(e);
  return html + "</table>" + figures_of(one) + "</section>\n";
}

std::string markdown_row(const Validated& one, const Expectation& e) {
  const bool explains = e.verdict() != Verdict::pass && !e.reason.empty();
  return fmt::format("| `{}` | {} | {} | {} | {} | {} | {}{} |\n", one.script.name,
                     markdown(e.quantity), markdown(expected_text(e)), markdown(tolerance_text(e)),
                     markdown(got_text(e)), markdown(source_text(e)), name_of(e.verdict()),
                     explains ? ": " + markdown(e.reason) : "");
}

std::string fails_of(const Validated& one) {
  std::string text;
  for (const Expectation& e : one.checks) {
    if (e.verdict() == Verdict::pass) continue;
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", name_of(e.verdict()),
                        markdown(e.quantity));
  }
  return text;
}

constexpr std::string_view closing = "<!-- end -->";

// Returns the line that opens a table, with its end.
std::string opening(std::string_view name) {
  return fmt::format("<!-- hackle validate: {} -->\n", name);
}

// Returns whether the text has a place for that table.
bool replace_table(std::string& text, std::string_view name, const std::string& table) {
  const std::string open = opening(name);
  const std::size_t begin = text.find(open);
  const std::size_t end = begin == std::string::npos ? begin : text.find(closing, begin);
  if (end == std::string::npos) return false;
  text.replace(begin + open.size(), end - begin - open.size(), fmt::format("\n{}\n", table));
  return true;
}

}  // namespace

std::string validation_page(std::span<const Validated> all, bool quick) {
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
      "<title>Validation of Hackle {0}</title><style>{1}</style></head><body><main>\n"
      "<h1>Validation of Hackle</h1><p class=\"faint\">version {0} (git {2}) &middot; {3} &middot; "
      "{4} of {5}, by hackle validate{6}</p>\n",
      version(), style, git_hash(), xml(processor_name()), plural(checks_of(all), "check"),
      plural(all.size(), "script"), quick ? " --quick" : "");
  html += counts_of(all) + contents_of(all);
  html +=
      "<p class=\"faint\">A mark on a bar tells where the value lies; the coloured part is what "
      "passes. In charts the line is expected, circles are Hackle&rsquo;s.</p>\n";
  for (const Validated& one : all) html += section_of(one);
  return html + "</main></body></html>\n";
}

std::string markdown_table(std::span<const Validated> all) {
  std::string text =
      "| script | quantity | expected | within | got | source | verdict |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Validated& one : all)
    for (const Expectation& e : one.checks) text += markdown_row(one, e);
  return text;
}

std::string markdown_summary(std::span<const Validated> all) {
  std::string text =
      "| script | what it is | checks | pass | others |\n| --- | --- | --- | --- | --- |\n";
  for (const Validated& one : all)
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", one.script.name, markdown(one.title),
                        one.checks.size(), count({&one, 1}, Verdict::pass), fails_of(one));
  return text;
}

std::string with_tables(std::string text, std::span<const Validated> all,
                        const std::filesystem::path& file) {
  const bool table = replace_table(text, "table", markdown_table(all));
  const bool summary = replace_table(text, "summary", markdown_summary(all));
  if (table || summary) return text;
  throw Error(ErrorKind::files,
              fmt::format("validate: '{}' has no place for the table", file.string()),
              fmt::format("write the lines {}{}", opening("table"), closing));
}

}  // namespace hackle
