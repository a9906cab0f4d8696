#!/bin/bash
# Completions and manual page, as shells and groff read them. Usage: test_shell_files.sh PROGRAM
# What zsh, fish and groff would do is left out, with a word, where they are not installed.
program=$1
. "$(dirname -- "$0")/scratch.sh"

mkdir runs && touch scene.toml notes.txt page.html
"$program" completion bash >bash || fail "no completion for bash"
"$program" completion zsh >_sluice || fail "no completion for zsh"
"$program" completion fish >fish || fail "no completion for fish"
"$program" help manual >sluice.1 || fail "no manual page"
"$program" completion tcsh >out 2>&1 && fail "a shell that is not known"

# offers EXPECTED WORD…: what bash offers for the last word, in one line.
# shellcheck source=/dev/null
. ./bash
offers() {
    local expected=$1
    shift
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    _sluice
    [ "${COMPREPLY[*]}" = "$expected" ] || fail "bash: $*: offers '${COMPREPLY[*]}', not '$expected'"
}
offers "new" sluice n
offers "run render" sluice r
offers "scene schema" sluice help s
offers "scene.toml" sluice check sc
offers "runs scene.toml" sluice run ""
offers "runs" sluice view ""
offers "runs" sluice run scene.toml --output ""
offers "--output" sluice run scene.toml --o
offers "method.spacing=" sluice run scene.toml --set method.sp
offers "mp4" sluice render runs --video m
offers "runs page.html" sluice view runs -o ""
offers "" sluice run scene.toml --threads ""
offers "dam-break dam-break-3d" sluice new d
offers "gravity" sluice help effects g
offers "method.spacing" sluice help scene method.sp
offers "bash" sluice completion b

if command -v fish >out; then
    # fish_offers EXPECTED LINE: without the descriptions.
    fish_offers() {
        got=$(fish -c "source ./fish; complete -C '$2'" | cut -f 1 | sort | tr '\n' ' ')
        [ "$got" = "$1 " ] || fail "fish: $2: offers '$got', not '$1'"
    }
    fish_offers "render run" "sluice r"
    fish_offers "dam-break dam-break-3d" "sluice new d"
    fish_offers "scene schema" "sluice help s"
    fish_offers "mp4" "sluice render runs --video m"
    fish_offers "gravity" "sluice help effects g"
else
    echo "fish is not installed: its completion is not tried"
fi
if command -v zsh >out; then
    zsh -n ./_sluice || fail "zsh cannot read its completion"
    cat >complete.zsh <<'ZSH'
zmodload zsh/zpty
zpty z zsh -f
zpty -w z 'PS1=; fpath=(. $fpath); autoload -U compinit; compinit -u -D; zstyle ":completion:*" list-prompt ""; LISTMAX=0'
zpty -w z $'bindkey "^I" expand-or-complete; print -r ready'
zpty -r z text '*ready*ready*' || zpty -r z text '*ready*'
zpty -w -n z $'sluice new sl\t'
sleep 2
zpty -r -t z text '*sloshing-tank*' && print -r found
zpty -d z
ZSH
    timeout 60 zsh -f complete.zsh 2>err | grep -q found || fail "zsh does not complete a template's name"
else
    echo "zsh is not installed: its completion is not tried"
fi
if command -v groff >out; then
    groff -man -ww -z -Kutf8 sluice.1 2>warnings
    [ -s warnings ] && fail "groff warns" && cat warnings
    groff -man -Tutf8 -Kutf8 -P-cbou sluice.1 >page || fail "groff cannot format the manual"
    for word in "sluice check" "sluice help scene" "--set" "--draw" "EXIT STATUS"; do
        grep -qF -- "$word" page || fail "the manual lacks $word"
    done
else
    echo "groff is not installed: the manual is not formatted"
fi

[ $failures -eq 0 ] || exit 1
echo "completions and manual"
