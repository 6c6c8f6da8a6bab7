// SPDX-License-Identifier: MIT
#include "app/command_docs.hpp"

#include <cstdio>

#include "app/exit_code.hpp"
#include "app/man_page.hpp"
#include "app/shell_completion.hpp"
#include "base/streams.hpp"

namespace hackle {
namespace {

std::string text_of(const DocsRequest& request, const std::vector<Command>& commands) {
  if (!request.completion.empty()) return shell_completion(commands, request.completion);
  return request.man ? man_page(commands) : markdown_page(commands);
}

}  // namespace

int command_docs(const DocsRequest& request, const std::vector<Command>& commands) {
  return exit_code_of([&] {
    const std::string text = text_of(request, commands);
    write_to(stdout, text);
    return 0;
  });
}

}  // namespace hackle
