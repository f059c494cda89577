#!/usr/bin/env bash
# Writes a manual page for each command, from its help text, with help2man:
#   app/manual_pages.sh PROGRAM FOLDER
set -euo pipefail
program=$(realpath "$1") folder=$2
version=$("$program" --version)
mkdir -p "$folder"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# help2man takes the name of the program from its file, sets options apart by a comma and a blank,
# and keeps the lines of examples that begin with a dollar sign.
page() {
  local name="clast${*:+-}${*}" text
  name=${name// /-}
  text=$("$program" help "$@")
  sed -e 's/^\(  -[a-zA-Z]\),--/\1, --/' -e '/^Examples:/,$ s/^  /  $ /' -e 's/^Examples:/\n&/' <<<"$text" >"$scratch/help"
  printf '#!/bin/sh\ncat %s\n' "$scratch/help" >"$scratch/$name"
  chmod +x "$scratch/$name"
  help2man --no-info --version-string "${version#clast }" \
    --name "$(head -n 1 <<<"$text" | sed 's/^clast: //')" "$scratch/$name" | gzip -9n >"$folder/$name.1.gz"
  local part
  for part in $(sed -n '/^Subcommands:/,/^$/ s/^  \([a-z]\+\) .*/\1/p' <<<"$text"); do
    page "$@" "$part"
  done
}
page
