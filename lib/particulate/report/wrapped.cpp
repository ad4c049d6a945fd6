#include <particulate/report/wrapped.hpp>

namespace particulate::report {

std::string wrapped(std::string_view text, std::size_t indent) {
  std::string lines;
  for (std::size_t room = screen_width;; room = screen_width - indent) {
    std::size_t end = text.size();
    if (end > room) {
      end = text.rfind(' ', room);
      if (end == std::string_view::npos || text.find_first_not_of(' ') > end) end = text.find(' ', room);
    }
    lines += text.substr(0, end);
    const std::size_t next = text.find_first_not_of(' ', end);
    if (next == std::string_view::npos) return lines;
    lines += '\n' + std::string(indent, ' ');
    text.remove_prefix(next);
  }
}

}  // namespace particulate::report
