# check_lesson.py LESSON PAGE...: whether the figures of the lesson's answer are numbers of its page where it opens, to the last digit.
import json
import re
import sys

lesson = open(sys.argv[1], encoding="utf-8").read()
answer = lesson[lesson.index("<summary>Answer</summary>"):lesson.index("</details>")]
numbers = []


def collect(value):
    if isinstance(value, dict):
        value = value.values()
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        numbers.append(abs(value))
    elif not isinstance(value, str) and value is not None and not isinstance(value, bool):
        for inner in value:
            collect(inner)


for name in sys.argv[2:]:
    text = open(name, encoding="utf-8").read()
    data = json.loads(re.search(r'<script type="application/json" id="data">(.*)</script>', text).group(1))
    # What the page opens with, lest one of its many thousand numbers agree by chance.
    x, y = data["focus"]["pixel"]
    for key in ("model", "counts", "view", "draws", "lighting"):
        collect(data[key])
    for triangle in data["triangles"]:
        if triangle["number"] == data["focus"]["triangle"]:
            for piece in triangle.get("pieces", []):
                piece.get("setup", {}).pop("coverage", None)
            collect(triangle)
        collect([triangle["number"]] + [piece.get("setup", {}).get("covered") for piece in triangle.get("pieces", [])])
    collect([f for f in data["fragments"] if (f["x"], f["y"]) == (x, y)])

missing = []
for figure in re.findall(r"(?<![\w.,])\d[\d,]*\d(?:\.\d+)?|(?<![\w.,])\d\.\d+", answer):
    plain = figure.replace(",", "")
    decimals = len(plain.partition(".")[2])
    if decimals == 0 and len(plain) < 4:  # counts, places, powers, bytes
        continue
    if not any(f"{n:.{decimals}f}" == plain for n in numbers):
        missing.append(figure)
print(" ".join(missing))
