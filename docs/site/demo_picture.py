"""Takes docs/demo.png, the picture in README.md, of the report that samples/demo.sh made.

    docs/site/demo_picture.py out/report/report.html docs/demo.png

It needs Chromium. The answer at the head of the report goes into the picture as its
description, which a test compares with what the demo says now.
"""

import html
import re
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

SIZE = (1266, 765)


def answer_of(report):
    """The sentences at the head of a report."""
    page = Path(report).read_text(encoding="utf-8")
    found = re.findall(r'<p class="answer">(.*?)</p>', page, re.S)
    plain = [html.unescape(re.sub(r"<[^>]*>", "", text)) for text in found]
    return " ".join(plain).replace("\N{NO-BREAK SPACE}", " ")


def with_description(png, text):
    """The PNG with a tEXt chunk after its header."""
    chunk = b"tEXt" + b"Description\0" + text.encode("latin-1")
    whole = struct.pack(">I", len(chunk) - 4) + chunk + struct.pack(">I", zlib.crc32(chunk))
    header = 8 + 25
    return png[:header] + whole + png[header:]


def main(report, target):
    with tempfile.TemporaryDirectory() as folder:
        shot = Path(folder, "shot.png")
        subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                        f"--window-size={SIZE[0]},{SIZE[1]}", "--virtual-time-budget=20000",
                        f"--screenshot={shot}", Path(report).resolve().as_uri()],
                       check=True, stderr=subprocess.DEVNULL)  # fmt: skip
        Path(target).write_bytes(with_description(shot.read_bytes(), answer_of(report)))


if __name__ == "__main__":
    main(*sys.argv[1:])
