#include "report/html/terms.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "report/html/html_page.hpp"

namespace clast::report_detail {
namespace {

struct Term {
  std::string_view word;     ///< as the page has it, escaped, in any case
  std::string_view id;       ///< of its explanation; several words can share one
  std::string_view meaning;  ///< plain text; empty where another word of the same id has it
};

// Longer words first, where one is a part of another.
constexpr std::array kTerms = {
    Term{"runout", "runout",
         "Horizontal distance from the release point to the stop, along the downslope direction."},
    Term{"lateral angle", "lateral",
         "Angle between downslope and the line from the release point to the stop, positive to the "
         "right looking downslope."},
    Term{"lateral mean", "lateral", ""},
    Term{"95 % intervals", "interval",
         "Ranges that contain the true value in 95 of 100 studies like this one. They do not cover "
         "errors of the model, such as wrong ground parameters."},
    Term{"95 % interval", "interval", ""},
    Term{"p95", "p95", "The value that 95 % of the runs stay below."},
    Term{"Cliff&#39;s delta", "delta",
         "Probability that a run of the first group has a larger value than a run of the second, "
         "minus the probability of the opposite: from -1 to 1. A magnitude below 0.15 is "
         "negligible, above 0.47 large."},
    Term{"Hedges&#39; g", "hedges",
         "The difference of the means divided by the standard deviation of single runs."},
    Term{"KS distance", "ks",
         "The largest distance between two cumulative curves (Kolmogorov and Smirnov), from 0 to "
         "1."},
    Term{"p (Holm)", "holm",
         "Probability that such a distance occurs by chance, corrected for the number of tests. A "
         "difference with a value below 0.05 is significant."},
    Term{"reach probability", "reach", "Fraction of all released blocks that reach a location."},
    Term{
        "s_c", "sc",
        "Length over width, minus 1 (L/I - 1): above 0.3 a block is elongated, else compact, after "
        "Garcia et al. (2022)."},
    Term{"clearance", "clearance", "Height of the lowest point of the block above the ground."},
    Term{"cumulative", "cumulative", "Fraction of the values that lie below."},
    Term{"penetration", "penetration", "How deep a block overlaps the ground in the simulation."},
    Term{"rank correlation", "rank",
         "1 if two quantities always increase together, -1 if one always decreases as the other "
         "increases, 0 without a trend."},
    Term{"fraction of variance", "variance",
         "Fraction of the variance of the outcome that one parameter explains alone."},
    Term{"travel angle", "travel",
         "Angle below the horizontal of the line from the crest to the toe of the deposit."},
    Term{"e_n\xC2\xB2", "restitution",
         "Energy restitution: the fraction of the energy of normal motion that a block keeps at an "
         "impact."},
    Term{"k_n", "stiffness", "Normal stiffness of a contact."},
    Term{"Sneed-Folk", "sneed", "Shape classes by L, I and S, after Sneed and Folk (1958)."},
    Term{"Zingg", "zingg", "Shape classes by I/L and S/I, after Zingg (1935)."}};

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Finds `word` in `text` as a whole word, in any case; npos if absent.
std::size_t find_word(std::string_view text, std::string_view word) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  for (auto from = text.begin();;) {
    const auto at = std::search(from, text.end(), word.begin(), word.end(), same);
    if (at == text.end()) return text.npos;
    const auto end = at + static_cast<std::ptrdiff_t>(word.size());
    if ((at == text.begin() || !is_letter(*(at - 1))) && (end == text.end() || !is_letter(*end))) {
      return static_cast<std::size_t>(at - text.begin());
    }
    from = at + 1;
  }
}

/// A text between two tags with its terms marked, those in `seen` left out.
std::string marked(std::string_view text, std::set<std::string_view>& seen) {
  for (const Term& term : kTerms) {
    if (seen.contains(term.id)) continue;
    const std::size_t at = find_word(text, term.word);
    if (at == text.npos) continue;
    seen.insert(term.id);
    const std::string_view word = text.substr(at, term.word.size());
    // The text before and after the word can contain other terms.
    return marked(text.substr(0, at), seen) + "<span class=\"term\" tabindex=\"0\" " +
           "aria-describedby=\"term-" + std::string(term.id) + "\">" + std::string(word) +
           "</span>" + marked(text.substr(at + word.size()), seen);
  }
  return std::string(text);
}

bool is_tag(std::string_view tag, std::string_view name) {
  return tag.starts_with(name) && tag.size() > name.size() && !is_letter(tag[name.size()]);
}

std::string explained(const std::set<std::string_view>& used) {
  std::string list;
  for (const Term& term : kTerms) {
    if (!used.contains(term.id) || term.meaning.empty()) continue;
    list += "<dt>" + std::string(term.word) + "</dt><dd id=\"term-" + std::string(term.id) + "\">" +
            escape_html(term.meaning) + "</dd>\n";
  }
  return format_section("Glossary",
                        format_folded_section("What the underlined words mean",
                                              "<dl class=\"words\">\n" + list + "</dl>\n"));
}

}  // namespace

std::string link_glossary_terms(std::string_view body) {
  std::string html;
  html.reserve(body.size());
  std::set<std::string_view> seen, used;
  int inside = 0;  // of elements whose text is looked at
  for (std::size_t at = 0; at < body.size();) {
    const std::size_t open = std::min(body.find('<', at), body.size());
    const std::string_view text = body.substr(at, open - at);
    html += inside > 0 ? marked(text, seen) : std::string(text);
    if (open == body.size()) break;
    const std::size_t close = std::min(body.find('>', open), body.size() - 1) + 1;
    const std::string_view tag = body.substr(open, close - open);
    html += tag;
    at = close;
    if (is_tag(tag, "<section")) {
      used.insert(seen.begin(), seen.end());
      seen.clear();
    } else if (is_tag(tag, "<p") || is_tag(tag, "<th") || is_tag(tag, "<li")) {
      ++inside;
    } else if (is_tag(tag, "</p") || is_tag(tag, "</th") || is_tag(tag, "</li")) {
      inside = std::max(0, inside - 1);
    } else if (is_tag(tag, "<script") || is_tag(tag, "<code") || is_tag(tag, "<a") ||
               is_tag(tag, "<svg")) {
      const std::string end = "</" + std::string(tag.substr(1, tag.find_first_of(" >") - 1)) + ">";
      const std::size_t after = std::min(body.find(end, at), body.size());
      html += body.substr(at, after - at);
      at = after;
    }
  }
  used.insert(seen.begin(), seen.end());
  return used.empty() ? html : html + explained(used);
}

}  // namespace clast::report_detail
