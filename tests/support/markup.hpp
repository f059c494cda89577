#pragma once
/// Whether HTML and SVG are well formed, and what they refer to.
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace clast {

inline std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

/// Empty when every tag that opens is closed in order; else what is wrong.
inline std::string unbalanced(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at)) {
    const std::size_t end = html.find('>', at);
    if (end == std::string::npos) return "unfinished tag";
    std::string tag = html.substr(at + 1, end - at - 1);
    at = end;
    if (tag.starts_with("!") || tag.starts_with("?") || tag.ends_with("/")) continue;
    const bool closing = tag.starts_with("/");
    if (closing) tag.erase(0, 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \n\t"));
    if (name.empty() || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz123456") != name.npos) {
      return "not a tag: <" + tag + ">";
    }
    if (name == "meta" || name == "input") continue;  // never closed
    if (!closing) {
      open.push_back(name);
      if (name == "script" || name == "style") at = html.find("</" + name, at);
    } else if (open.empty() || open.back() != name) {
      return "</" + name + "> closes <" + (open.empty() ? "" : open.back()) + ">";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> stays open";
}

/// What makes a page need more than itself; names of XML vocabularies are no links.
inline void expect_self_contained(std::string html) {
  const std::string name_space = "xmlns=\"http://www.w3.org/2000/svg\"";
  for (std::size_t at = html.find(name_space); at != std::string::npos;
       at = html.find(name_space)) {
    html.erase(at, name_space.size());
  }
  for (const char* outside : {"http:", "https:", "src=", "@import", "url(", "<link"}) {
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  }
  EXPECT_EQ(count_of(html, "href="),
            count_of(html, "href=\"data:image/png;base64,") + count_of(html, "href=\"#"));
}

}  // namespace clast
