# shellcheck shell=bash
# Shared by server/run.sh and tests/run.sh; sourced, with ROOT set to the repository.

# missing_headers COMPILER: of lines "package header", the packages whose header it does not find.
missing_headers() {
  local package header source=''
  while read -r package header; do
    source+="#if !__has_include(<$header>)"$'\n'"\"$package\""$'\n#endif\n'
  done
  if command -v "$1" >/dev/null; then
    source=$("$1" -std=c++20 -E -P -x c++ - <<< "$source")
  fi
  sed -n 's/^"\(.*\)"$/\1/p' <<< "$source"
}

# missing_packages SECTION: the packages of a section of packages.txt whose command or header is
# nowhere to be found. Package names do not matter: a node or a compiler from elsewhere counts.
missing_packages() {
  local section package kind probe headers='' clang_headers=''
  while read -r section package kind probe; do
    [ "$section" = "$1" ] || continue
    case $kind in
      command) command -v "$probe" >/dev/null || echo "$package" ;;
      file) [ -e "$probe" ] || echo "$package" ;;
      header) headers+="$package $probe"$'\n' ;;
      clang-header) clang_headers+="$package $probe"$'\n' ;;
    esac
  done < "$ROOT/server/packages.txt"
  missing_headers "${CXX:-c++}" < <(printf %s "$headers")
  missing_headers clang++ < <(printf %s "$clang_headers")
}

# install_missing SECTION: installs them with apt; calls nothing when all is there.
install_missing() {
  local packages sudo=()
  mapfile -t packages < <(missing_packages "$1")
  [ ${#packages[@]} -gt 0 ] || return 0
  if ! command -v apt-get >/dev/null; then
    echo "Missing, and there is no apt-get to install it: ${packages[*]}" >&2
    return 1
  fi
  if [ "$(id -u)" != 0 ]; then
    sudo=(sudo)
    echo "Installing with sudo, because you are not root:"
  fi
  echo "apt-get install ${packages[*]}"
  "${sudo[@]}" apt-get update -qq || echo "apt-get update failed; trying with what apt knows" >&2
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    -o DPkg::Lock::Timeout=300 "${packages[@]}"
}
