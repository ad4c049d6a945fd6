#include <particulate/report/spelling.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace particulate::report {
namespace {

// Insertions, deletions and substitutions that turn one word into the other.
std::size_t distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t substituted = diagonal + (from[i - 1] == to[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[to.size()];
}

bool contains(std::string_view whole, std::string_view part) {
  return part.size() >= 3 && whole.find(part) != std::string_view::npos;
}

}  // namespace

std::vector<std::string> near_matches(std::string_view given, const std::vector<std::string>& known) {
  std::vector<std::pair<std::size_t, std::string>> near;
  for (const std::string& word : known) {
    const std::size_t edits = distance(given, word);
    if (edits <= std::max<std::size_t>(1, word.size() / 3) || contains(word, given) || contains(given, word)) {
      near.emplace_back(edits, word);
    }
  }
  std::sort(near.begin(), near.end());
  std::vector<std::string> words;
  for (const auto& [edits, word] : near) {
    if (words.size() < 3) words.push_back(word);
  }
  return words;
}

std::string either(const std::vector<std::string>& words) {
  std::string phrase;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) phrase += i + 1 == words.size() ? " or " : ", ";
    phrase += words[i];
  }
  return phrase;
}

}  // namespace particulate::report
