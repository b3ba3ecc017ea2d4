#!/usr/bin/env bash
# image.sh BUILD IMAGE: lays out what the container image holds, from a finished build: the program,
# the libraries that it loads, everybody's licences, and sbom.spdx.json, which tells by the package
# database what all that is (SPDX 2.3). Needs Debian; what no package owns is an error.
set -euo pipefail
ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$1 image=$2

# libraries: the files that the program loads.
libraries() { ldd "$build/tia" | grep -o '/[^ ]*'; }

# headers: the files of the system that our own sources include.
headers() {
  ninja -C "$build" -t deps |
    awk '/^[^ ]/ { ours = /^(server\/)?CMakeFiles\/tia/ } /^ / && ours && $1 ~ /^\/usr/ { print $1 }' | sort -u
}

# names: of the packages in dpkg -S's lines, those of this machine's architecture. A header may be of
# several: "libx-dev:amd64, libx-dev:arm64: /usr/include/x.h".
names() { sed 's/: .*//; s/, /\n/g' | grep -E "^[^:]+(:$(dpkg --print-architecture))?$"; }

# owner FILE: its package. What was merged into /usr is known by the one path or the other.
owner() {
  { dpkg -S "${1#/usr}" || dpkg -S "/usr${1#/usr}"; } 2>/dev/null | names ||
    { echo "$0: no package owns $1" >&2 && return 1; }
}

# licence PACKAGE: as an SPDX expression, where Debian's copyright file or we know it.
licence() {
  case $1 in
    libc6) echo LGPL-2.1-or-later ;;
    libseccomp2) echo LGPL-2.1-only ;;
    libjpeg62-turbo) echo IJG AND BSD-3-Clause AND Zlib ;;
    libvpx7 | libwebp7 | libwebpmux3) echo BSD-3-Clause ;;
    libdraco-dev) echo Apache-2.0 ;;
    libgcc-s1 | libstdc++6) echo GPL-3.0-or-later WITH GCC-exception-3.1 ;;
    libsqlite3-0) echo blessing ;;
    libstb-dev) echo MIT OR Unlicense ;;
    linux-libc-dev) echo GPL-2.0-only WITH Linux-syscall-note ;;
    *) awk '/^Files: *\*/ { all = 1 } all && sub(/^License: */, "") { print; exit }' \
         "/usr/share/doc/$1/copyright" |
         sed -E 's/^Expat$/MIT/; s/^Boost$/BSL-1.0/; s/^BSD-3-clause$/BSD-3-Clause/
                 /^(Apache-2\.0|BSD-3-Clause|BSL-1\.0|MIT|Zlib)$/!s/.*/NOASSERTION/' |
         grep . || echo NOASSERTION ;;
  esac
}

# packages LINK: a line for each whose name is read: how we link it, name, version, architecture,
# source, the source's version.
packages() {
  # shellcheck disable=SC2016
  local fields='${Package}\t${Version}\t${Architecture}\t${source:Package}\t${source:Version}\n'
  names | sort -u | xargs dpkg-query -W -f "$1\t$fields"
}

# contents: those lines for all that is in the image: what is loaded, and what is compiled in. That is
# any package of headers that has no library here: what of a library's own is compiled in is its.
contents() {
  libraries | while read -r file; do owner "$file" || exit; done | packages DYNAMIC_LINK
  headers | xargs dpkg -S | packages STATIC_LINK
}

# sbom: the document, from lines of contents that end in a licence.
sbom() {
  local version sha256 os
  version=$("$build/tia" --version | sed 's/.* //')
  sha256=$(sha256sum < "$image/tia" | sed 's/ .*//')
  # shellcheck source=/dev/null
  os=$(. /etc/os-release && echo "$ID $VERSION_ID")
  awk -F '\t' -v version="$version" -v sha256="$sha256" -v os_release="$os" \
    -v created="$(date -u -d "@${SOURCE_DATE_EPOCH:-$(date +%s)}" +%Y-%m-%dT%H:%M:%SZ)" \
    -f "$ROOT/server/sbom.awk"
}

for file in $(libraries); do install -D "$file" "$image$file"; done
install -D --strip "$build/tia" "$image/tia"
install -m 644 "$ROOT/LICENSE" "$image/LICENSE"
contents | awk -F '\t' '$1 == "DYNAMIC_LINK" { here[$5] = 1 } $1 == "DYNAMIC_LINK" || !here[$5]' |
  while IFS=$'\t' read -r link name rest; do
    install -D -m 644 "/usr/share/doc/$name/copyright" "$image/usr/share/doc/$name/copyright"
    printf '%s\t%s\t%s\t%s\n' "$link" "$name" "$rest" "$(licence "$name")"
  done | sbom > "$image/sbom.spdx.json"
