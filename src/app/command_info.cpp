// SPDX-License-Identifier: MIT
#include "app/command_info.hpp"

#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/exit_code.hpp"
#include "app/file_facts.hpp"
#include "app/libraries.hpp"
#include "app/voice.hpp"
#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/machine.hpp"
#include "base/streams.hpp"
#include "base/units.hpp"
#include "base/version.hpp"
#include "render/gl/gl_context.hpp"
#include "solver/cpu/kernel.hpp"

namespace hackle {
namespace {

std::string gl_renderer() {
  try {
    return GlContext(64, 64).renderer();
  } catch (const Error& error) {
    return std::string("none: ") + error.what();
  }
}

nlohmann::ordered_json facts() {
  nlohmann::ordered_json facts;
  facts["schema"] = 1;
  facts["version"] = version();
  facts["git"] = git_hash();
  facts["compiler"] = compiler();
  for (const Library& library : libraries()) facts["libraries"][library.name] = library.version;
  facts["gl_library"] = gl_library_names[static_cast<std::size_t>(chosen_gl_library())];
  facts["gl_renderer"] = gl_renderer();
  facts["processor"] = processor_name();
  facts["instruction_set"] =
      instruction_set_names[static_cast<std::size_t>(best_instruction_set())];
  facts["cores"] = available_cores();
  facts["memory_bytes"] = available_memory();
  return facts;
}

std::string text_of(const nlohmann::ordered_json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

void print_line(const std::string& name, const std::string& value) {
  print_out("{:<16} {}\n", name, value);
}

void print(const nlohmann::ordered_json& facts) {
  print_line("hackle",
             fmt::format("{} (git {})", text_of(facts["version"]), text_of(facts["git"])));
  print_line("compiler", text_of(facts["compiler"]));
  for (const auto& [name, version] : facts["libraries"].items()) print_line(name, text_of(version));
  print_line("OpenGL",
             fmt::format("{}, {}", text_of(facts["gl_library"]), text_of(facts["gl_renderer"])));
  print_line("processor",
             fmt::format("{}, {} cores", text_of(facts["processor"]), text_of(facts["cores"])));
  print_line("instructions", text_of(facts["instruction_set"]));
  print_line("free memory", quantity(facts["memory_bytes"].get<double>(), "B"));
}

void print(const FileFacts& facts) {
  for (const auto& [name, text] : facts.lines) print_line(name, printable(text));
  for (const std::string& next : facts.next)
    print_line(&next == facts.next.data() ? "next" : "", next);
}

void print_about_file(const InfoRequest& request) {
  FileFacts facts = facts_of_file(request.file);
  if (!request.json) return print(facts);
  facts.json["next"] = facts.next;
  using Json = nlohmann::ordered_json;
  print_out("{}\n", facts.json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void print_about_program(bool json) {
  if (json)
    print_out("{}\n", facts().dump());
  else
    print(facts());
}

}  // namespace

int command_info(const InfoRequest& request) {
  const InterruptHandler handler;
  return exit_code_of([&request] {
    if (request.file.empty())
      print_about_program(request.json);
    else
      print_about_file(request);
    return 0;
  });
}

}  // namespace hackle
