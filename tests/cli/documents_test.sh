#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# documents_test.sh TOOL WORK: the man page and the completion of bash have every command and option that --help has, and
# no other. fish, zsh and groff are asked where they are.
set -euo pipefail
tool=$1 work=$2
fail() { echo "$*" >&2; exit 1; }
rm -rf "$work" && mkdir -p "$work/bin" "$work/here/a folder"
ln -s "$tool" "$work/bin/qvgen"
PATH=$work/bin:$PATH
cd "$work/here"
touch "my arm.toml"

# complete WORDS...: what bash offers for the last of them, a line each.
complete_words() {
  bash -c 'eval "$(qvgen completion bash)"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _qvgen
           ((${#COMPREPLY[@]} == 0)) || printf "%s\n" "${COMPREPLY[@]}"' bash "$@"
}
expect() {
  local expected=$1
  shift
  [[ $(complete_words "$@" | paste -sd,) == "$expected" ]] || fail "completing '$*' gives: $(complete_words "$@" | paste -sd,)"
}
# options_in: those of a help text or of a piece of the man page, sorted.
options_in() { grep -oE '^ *(-[a-z], ?)?--[a-z-]+' | grep -oE -- '--[a-z-]+' | sort; }

qvgen man | sed 's/\\f[BIR]//g; s/\\-/-/g' > "$work/man"
commands=$(qvgen --help | sed -n '/^Subcommands:/,/^$/p' | awk 'NR > 1 && NF { print $1 }')
[[ $(wc -w <<<"$commands") -ge 10 ]] || fail "only these commands: $commands"
[[ $(complete_words qvgen "" | sort) == $(sort <<<"$commands") ]] || fail "commands in bash: $(complete_words qvgen "")"
[[ $(sed -n 's/^\.SS //p' "$work/man") == "$commands" ]] || fail "commands in the man page: $(grep '^\.SS' "$work/man")"
for command in $commands; do
  help=$(qvgen "$command" --help | options_in)
  [[ -n $help ]]
  offered=$(complete_words qvgen "$command" -- | sort)
  [[ $offered == "$help" ]] || fail "bash offers for $command: $offered"
  page=$(sed -n "/^\.SS $command\$/,/^\.S[SH] /p" "$work/man" | options_in)
  [[ $page == "$help" ]] || fail "the man page has for $command: $page"
done

expect "generate" qvgen gen
expect "--language" qvgen generate ur5 --la
expect "cxx,c,cuda" qvgen generate --language c
expect "a folder" qvgen generate --output ""
expect "inverse" qvgen generate --only inv
expect "ur5" qvgen generate ur
expect "my arm.toml" qvgen import m
expect "" qvgen generate --seconds ""
expect "euler,none" qvgen new RRP --wrist ""
qvgen list | grep -qx puma560

if command -v groff >/dev/null; then
  said=$(qvgen man | groff -man -Tascii -ww 2>&1 >/dev/null)
  [[ -z $said ]] || fail "groff: $said"
fi
if command -v fish >/dev/null; then
  qvgen completion fish > "$work/qvgen.fish"
  offered=$(fish -c "source $work/qvgen.fish; complete -C 'qvgen generate --la'" | cut -f1)
  [[ $offered == --language ]] || fail "fish offers: $offered"
fi
if command -v zsh >/dev/null; then
  qvgen completion zsh > "$work/_qvgen"
  # Says what is handed to zsh's own function for a command's arguments.
  cat > "$work/ask.zsh" <<'ZSH'
compdef() { :; }
_arguments() {
  if [[ $1 == -C ]]; then state=rest; line=($asked); else print -rl -- "$@"; fi
}
asked=$2
source $1
_qvgen
ZSH
  for command in $commands; do
    help=$(qvgen "$command" --help | options_in)
    offered=$(zsh -f "$work/ask.zsh" "$work/_qvgen" "$command" | grep -oE -- '^\*?--[a-z-]+' | tr -d '*' | sort)
    [[ $offered == "$help" ]] || fail "zsh offers for $command: $offered"
  done
fi
