"""HTML of what the page repeats."""
import html
import re


def esc(text):
    return html.escape(str(text))


def marked(text):
    """Escaped, with the little of Markdown that tables' notes have; the star of t* is none of it."""
    return re.sub(r"(?<!\w)\*(\w[^*]*)\*", r"<em>\1</em>", re.sub(r"`([^`]+)`", r"<code>\1</code>", esc(text)))


def cell(content, tag="td", kind="", name=""):
    """kind: number, wanted, soft (page.css). name: stands before the content where a phone shows no header."""
    attributes = (f' class="{kind}"' if kind else "") + (f' data-name="{name}"' if name else "")
    return f"<{tag}{attributes}>{content}</{tag}>"


def row(cells, kind=""):
    return f'<tr class="{kind}">{"".join(cells)}</tr>' if kind else f'<tr>{"".join(cells)}</tr>'


def table(header, rows, kind="words"):
    """header: cells, or none; rows: as row() makes them; kind: words (set to the left), cases, or nothing (numbers)."""
    head = f"<thead>{row(header)}</thead>" if header else ""
    return f'<div class="scroll"><table class="{kind}">{head}<tbody>{"".join(rows)}</tbody></table></div>'


def headings(*names, number=()):
    """Header cells; `number`: which of them stand over numbers."""
    return [cell(esc(name), "th", "number" if i in number else "") for i, name in enumerate(names)]
