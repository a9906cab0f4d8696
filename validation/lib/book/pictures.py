"""Pictures inside the page: SVGs take its colours, in light and dark, everything else stands on white."""
import base64
import html
import re

from lib import style

NAMED = {style.BLUE: "--blue", style.VERMILION: "--vermilion", style.GREEN: "--green", style.PURPLE: "--purple",
         style.ORANGE: "--orange", style.SKY: "--sky"}
CSS_PER_POINT = 96 / 72  # pixels
MAGNIFIED = 1.25         # text of 9 points as large as the captions
SMALLEST = 0.47          # of that: a figure of 6.3 inches just fits a phone; what is wider then scrolls


def picture(path, key, caption):
    """An <svg> or <img>. key: of its own in the page, as a picture's inner names must not meet another's."""
    if path.suffix == ".svg":
        return _inline(path.read_text(), key, caption)
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<img src="data:image/png;base64,{data}" alt="{html.escape(caption, quote=True)}">'


def _inline(text, key, caption):
    text = re.sub(r"<\?xml.*?\?>|<!DOCTYPE.*?>|<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    names = set(re.findall(r'\bid="([^"]+)"', text))
    text = re.sub(r'\bid="([^"]+)"', rf'id="{key}-\1"', text)
    text = re.sub(r'(url\(#|href="#)([^")]+)', lambda m: f"{m[1]}{key}-{m[2]}" if m[2] in names else m[0], text)
    text = re.sub(r"#[0-9a-f]{6}\b", _colour, text)
    text = re.sub(r"font: ((?:\w+ )*[\d.]+px) [^;\"]*", r"font: \1 var(--sans)", text)
    text = re.sub(r'font-family="[^"]*"', 'font-family="var(--sans)"', text)
    head = re.search(r"<svg\b[^>]*>", text)
    return text[:head.start()] + _head(head[0], caption) + text[head.end():]


def _head(tag, caption):
    """Without a size of its own: no larger than it was drawn for, and not so small that its text cannot be read."""
    width, unit = re.search(r'\bwidth="([\d.]+)(pt)?"', tag).groups()
    pixels = float(width) * (CSS_PER_POINT * MAGNIFIED if unit else 1)
    tag = re.sub(r'\s(width|height)="[^"]*"', "", tag)
    size = f"max-width: {pixels:.0f}px; min-width: {SMALLEST * pixels:.0f}px"
    return f'{tag[:-1]} role="img" aria-label="{html.escape(caption, quote=True)}" style="{size}">'


def _colour(match):
    """Greys lie between the page's ink and paper; the house's colours are the page's, a little brighter in the dark."""
    if match[0] in NAMED:
        return f"var({NAMED[match[0]]})"
    red, green, blue = (int(match[0][i:i + 2], 16) for i in (1, 3, 5))
    if not red == green == blue:
        return match[0]
    return f"color-mix(in srgb, var(--ink) {100 * (1 - red / 255):.0f}%, var(--paper))"


def draw_convergence(lines, path):
    """lines: of Errors, as plain data. Errors against particles across, with the slopes of first and second order."""
    plt = style.use()
    figure, axis = plt.subplots(figsize=(5.2, 3.8), layout="constrained")
    colours = (style.BLUE, style.VERMILION, style.GREEN, style.ORANGE, style.PURPLE, style.SKY)
    for i, line in enumerate(lines):
        axis.loglog(line["across"], [100 * e for e in line["errors"]], "o-", color=colours[i % len(colours)], markersize=4,
                    linewidth=1, label=line["name"])
    ends = sorted({n for line in lines for n in line["across"]})
    top = 100 * max(e for line in lines for e in line["errors"])
    for order, dashes in ((1, (0, (5, 2))), (2, (0, (1, 1.5)))):
        axis.loglog([ends[0], ends[-1]], [1.6 * top, 1.6 * top * (ends[0] / ends[-1]) ** order], color="0.5", linestyle=dashes,
                    linewidth=0.9, label=("first", "second")[order - 1] + " order")
    axis.set_xticks(ends, [f"{n:g}" for n in ends])
    axis.minorticks_off()
    axis.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axis.set(xlabel="particles across", ylabel="error [%]")
    axis.grid(color="0.92", linewidth=0.5)
    axis.legend(fontsize=7.5, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    style.save(figure, path)
