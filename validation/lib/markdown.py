"""Generated result tables."""


def table(header, rows):
    """A Markdown table; the first column is text, the others are numbers set to the right."""
    lines = ["| " + " | ".join(header) + " |", "| " + " | ".join(["---"] + ["---:"] * (len(header) - 1)) + " |"]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def number(value, digits):
    return "–" if value is None or value != value else f"{value:.{digits}f}"
