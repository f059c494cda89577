"""Anchors of headings as GitHub makes them, so that one link serves there and on the site."""

import re


def github_slug(text: str, separator: str) -> str:
    kept = re.sub(r"[^\w\- ]", "", text.strip().lower())
    return kept.replace(" ", separator)
