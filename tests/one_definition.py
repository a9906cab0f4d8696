#!/usr/bin/env python3
"""No class has two definitions of one name: the linker would take either for both. Usage: one_definition.py ROOT

Looks at what is defined in named namespaces, in headers and source files alike. Classes of functions and of anonymous
namespaces are their file's own.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

# What is linked into one program: the library, and a folder of tests or benchmarks with those whose headers it includes.
LIBRARY = ("neighbor", "kernels", "engine")
PROGRAMS = (("neighbor", "kernels", "tests/neighbor", "tests/kernels"), (*LIBRARY, "tests/engine", "tests/neighbor"),
            (*LIBRARY, "tests/engine", "tests/sanitized"), (*LIBRARY, "tests/engine", "tests/random_scenes"),
            (*LIBRARY, "tests/engine", "tests/fuzz"), (*LIBRARY, "bench"))
# Comments, raw strings, strings, characters (not the ' in 10'000) and preprocessor lines with their continuations.
NO_CODE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\''
    r'|^[ \t]*\#(?:\\\n|[^\n])*', re.DOTALL | re.MULTILINE)
TOKEN = re.compile(r"\w+|::|\[\[.*?\]\]|\S", re.DOTALL)


def tokens_of(text):
    blanked = NO_CODE.sub(lambda match: "\n" * match[0].count("\n") or " ", text)
    line, seen = 1, 0
    for match in TOKEN.finditer(blanked):
        line += blanked.count("\n", seen, match.start())
        seen = match.start()
        if not match[0].startswith("[["):
            yield match[0], line


def after_brackets(words, at, opening, closing):
    """The place behind the bracket that closes the one at `at`."""
    depth = 0
    while at < len(words):
        depth += (words[at] == opening) - (words[at] == closing)
        at += 1
        if depth == 0:
            break
    return at


def read_namespace(words, at):
    """(name, place of its brace) of the namespace at `at`; name None if it is an alias or a using."""
    name, at = "", at + 1
    while at < len(words) and (words[at] == "::" or words[at].isidentifier()):
        name += "" if words[at] == "inline" else words[at]
        at += 1
    return (name if at < len(words) and words[at] == "{" else None), at


def read_class(words, at):
    """(name, place of its brace) of the class, union or enumeration at `at`; None if it is not defined there."""
    at += 1
    while at < len(words) and words[at] in ("class", "struct"):
        at += 1
    begin = at
    while at < len(words) and (words[at] == "::" or words[at].isidentifier()):
        at += 1
        if words[at - 1].isidentifier() and words[at:at + 1] != ["::"]:
            break
    if at == begin:
        return None
    if words[at:at + 1] == ["<"]:  # a specialisation is a class of its own
        at = after_brackets(words, at, "<", ">")
    name = "".join(words[begin:at])
    if words[at:at + 1] == ["final"]:
        at += 1
    if words[at:at + 1] == [":"]:
        while at < len(words) and words[at] not in ("{", ";", ")"):
            at += 1
    return (name, at) if words[at:at + 1] == ["{"] else None


def definitions(text):
    """(name with its namespaces, line) of each class that is defined in a named namespace or in a class of one."""
    pairs = list(tokens_of(text))
    words, lines = [word for word, _ in pairs], [line for _, line in pairs]
    scopes, at = [], 0   # None: what is a file's own
    while at < len(words):
        word, name = words[at], None
        if word == "namespace" and words[at - 1:at] != ["using"]:
            name, brace = read_namespace(words, at)
            if name is not None:
                scopes.append(name or None)
                at = brace
        elif word == "template" and words[at + 1:at + 2] == ["<"]:
            at = after_brackets(words, at + 1, "<", ">") - 1
        elif word in ("class", "struct", "union", "enum") and (found := read_class(words, at)):
            name, brace = found
            if None not in scopes:
                yield "::".join([*scopes, name]), lines[at]
            scopes.append(name)
            at = brace
        elif word == "{":
            scopes.append(None)
        elif word == "}" and scopes:
            scopes.pop()
        at += 1


def find_doubles(files):
    """name → places, of the names that stand in more than one place. `files`: path → definitions in it."""
    places = defaultdict(list)
    for path, defined in files.items():
        for name, line in defined:
            places[name].append(f"{path}:{line}")
    return {name: where for name, where in places.items() if len(where) > 1}


def check_itself():
    """A check that reads nothing finds nothing."""
    text = """
        #define BODY struct Macro {
        namespace a::b { namespace { struct Own {}; }
        template <class T, template <class> class U> class [[nodiscard]] Box final : public Base<T> { enum class Kind : int { x }; };
        template <> struct Box<int> {}; struct Declared; enum Plain { y }; /* struct Comment {}; */
        inline int f(struct Declared& d) { struct Local {}; auto s = "struct Text {"; return 10'000 + '{'; }
        } // namespace a::b
        namespace c { union Last {}; struct Last2 { struct Inner {}; } made = {}; }"""
    names = [name for name, _ in definitions(text)]
    expected = ["a::b::Box", "a::b::Box::Kind", "a::b::Box<int>", "a::b::Plain", "c::Last", "c::Last2", "c::Last2::Inner"]
    if names != expected:
        raise SystemExit(f"one_definition: read {names}, expected {expected}")
    doubles = find_doubles({"one.hpp": definitions("namespace a { struct B {}; }"),
                            "two.hpp": definitions("\nnamespace a {\nclass B {};\n}")})
    if doubles != {"a::B": ["one.hpp:1", "two.hpp:3"]}:
        raise SystemExit(f"one_definition: found {doubles}")


def read_folder(root, folder):
    paths = sorted(path for kind in ("*.hpp", "*.cpp") for path in (root / folder).rglob(kind))
    return {path.relative_to(root): list(definitions(path.read_text())) for path in paths}


def main(root):
    check_itself()
    folders = {folder: read_folder(root, folder) for folder in sorted(set(sum(PROGRAMS, ())))}
    count = sum(len(defined) for files in folders.values() for defined in files.values())
    if count < 300:
        raise SystemExit(f"one_definition: read {count} classes: that cannot be all")
    doubles = {}
    for program in PROGRAMS:
        doubles |= find_doubles({path: defined for folder in program for path, defined in folders[folder].items()})
    for name, where in doubles.items():
        print(f"{name} is defined in {' and '.join(where)}")
    if doubles:
        raise SystemExit("one_definition: FAILED")
    print(f"one_definition: {count} classes, each defined once")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
