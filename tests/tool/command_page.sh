#!/bin/bash
# command_page.sh [--update] PROGRAM PAGE: whether the blocks of PAGE that follow <!-- raster ... --help --> are what the
# program prints; with --update, makes them so.
set -eu
update=
if [ "$1" = --update ]; then
    update=yes
    shift
fi
program=$1
page=$2
new=$(mktemp)
trap 'rm -f "$new"' EXIT

skipping=
while IFS= read -r line; do
    if [ -n "$skipping" ]; then
        [ "$line" != '```' ] || skipping=
        continue
    fi
    printf '%s\n' "$line"
    if [[ $line =~ ^\<!--\ raster\ (.*)\ --\>$ ]]; then
        echo '```text'
        # shellcheck disable=SC2086
        "$program" ${BASH_REMATCH[1]}
        echo '```'
        skipping=yes
    fi
done <"$page" >"$new"

if [ -n "$update" ]; then
    cmp -s "$new" "$page" || cp "$new" "$page"
else
    diff -u "$page" "$new"
fi
