"""One look for all pictures: sans-serif, thin axes, colours that colour-blind readers can tell apart (Okabe & Ito)."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)
from matplotlib.collections import PathCollection, QuadMesh  # noqa: E402
from matplotlib.colors import LinearSegmentedColormap  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402

BLACK, ORANGE, SKY, GREEN, YELLOW, BLUE, VERMILION, PURPLE = (
    "#000000", "#e69f00", "#56b4e9", "#009e73", "#f0e442", "#0072b2", "#d55e00", "#cc79a7")
WALL_GREY = "#8a8a8a"
COARSE_TO_FINE = (GREEN, ORANGE, SKY, BLUE)  # of up to four spacings; the finest is always blue
MANY = 200  # dots: from here on an SVG holds them as a picture, not one by one


def shortened(name, start, end):
    """A colour map without its ends that are too pale or too dark to see."""
    source = matplotlib.colormaps[name]
    return LinearSegmentedColormap.from_list(
        f"{name}_{start}_{end}", [source(start + (end - start) * i / 255) for i in range(256)])


WATER = shortened("Blues", 0.28, 1.0)
RUBBER = shortened("Oranges", 0.25, 0.95)
SIGNED = matplotlib.colormaps["RdBu_r"]


def use():
    plt.rcParams.update({
        "font.size": 9, "font.family": "sans-serif", "axes.linewidth": 0.6, "axes.spines.top": False,
        "axes.spines.right": False, "xtick.major.width": 0.6, "ytick.major.width": 0.6, "lines.linewidth": 1.4,
        "legend.frameon": False, "svg.fonttype": "none", "svg.hashsalt": "sluice", "figure.dpi": 100,
        "savefig.dpi": 160, "axes.titlesize": 9, "axes.labelsize": 9})
    return plt


def scale(colours, low, high):
    """Values to colours, to be shared by pictures and their colour bar."""
    return matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(low, high), colours)


def save(figure, path):
    """Without a date, so that the same run gives the same file."""
    is_svg = str(path).endswith(".svg")
    for axes in figure.axes if is_svg else ():
        for artist in axes.get_children():
            artist.set_rasterized(isinstance(artist, QuadMesh) or _dots(artist) > MANY)  # a colour bar's cells show seams
    metadata = {"Date": None} if is_svg else None
    figure.savefig(path, metadata=metadata)
    plt.close(figure)


def _dots(artist):
    """How many markers an artist draws: a scatter, or a curve of markers without a line."""
    if isinstance(artist, PathCollection):
        return len(artist.get_offsets())
    if isinstance(artist, Line2D) and artist.get_linestyle() == "None":
        return len(artist.get_xdata())
    return 0


def dot_area(axes, spacing):
    """Marker area in points² that draws a particle as wide as its spacing; axes limits must be set."""
    box = axes.get_window_extent()
    left, right = axes.get_xlim()
    points_per_metre = box.width / (right - left) * 72 / axes.figure.dpi
    return (spacing * points_per_metre) ** 2
