#!/bin/bash
# check.sh FOLDER: does this bundle run by itself? Copies it elsewhere, checks where every library
# comes from, and renders a picture without the environment and, where that can be done, without
# the sources and what was built.
set -euo pipefail
folder=$(readlink -f "$1")
root=$(readlink -f "$(dirname "$0")/../..")
fail() { echo "bundle: $1" >&2; exit 1; }

elsewhere=$(mktemp -d)
trap 'rm -rf "$elsewhere"' EXIT
cp -a "$folder" "$elsewhere/moved here"
moved="$elsewhere/moved here"

# Every library that a program needs to start is in the folder or belongs to the C library.
libraries=$(env -i LD_LIBRARY_PATH="$moved/lib/cxx:$moved/lib/x11" ldd "$moved/bin/romascope")
outside=$(awk '$2 == "=>"' <<<"$libraries" | grep -vF "=> $moved/" |
    grep -vE '^\s*lib(c|m|dl|pthread|rt)\.so' || true)
[ -z "$outside" ] || fail "libraries from outside the folder: $outside"
grep -F "=> $moved/" <<<"$libraries" | grep -q libembree || fail "Embree is not taken from the folder"
# shellcheck disable=SC2016 # the loader expands $ORIGIN, not the shell
if readelf -d "$moved/bin/romascope" | grep -iE 'r(un)?path' | grep -qvF '[$ORIGIN/../lib]'; then
    fail "the program looks for libraries in a fixed folder"
fi

# A namespace of its own hides the sources and the build; without the right to one, go on without.
user=(--map-root-user)
[ "$(id -u)" -ne 0 ] || user=()
# shellcheck disable=SC2016
hidden=(unshare --mount "${user[@]}" sh -c 'mount -t tmpfs none "$0" && exec "$@"' "$root")
if ! "${hidden[@]}" true 2>/dev/null; then
    hidden=()
    echo "bundle: mount namespaces are not allowed here; the sources stay visible to the check"
fi
away() { (cd / && "${hidden[@]}" env -i HOME="$elsewhere" "$@"); }
away PATH=/usr/bin:/bin "$moved/romascope" render cornell -o "$elsewhere/picture.png" \
    --size 160x120 --reference 4 --report "$elsewhere/report.json" ||
    fail "the program does not render from another folder"
[ "$(head -c 4 "$elsewhere/picture.png" | tail -c 3)" = PNG ] || fail "no picture was written"
grep -q "\"file\": \"$moved/.*share/romascope/assets/cornell.glb\"" "$elsewhere/report.json" ||
    fail "the scene was not taken from the folder"

# A machine whose ldconfig knows neither X11 nor the C++ library.
mkdir "$elsewhere/bin"
printf '#!/bin/sh\n' >"$elsewhere/bin/ldconfig"
chmod +x "$elsewhere/bin/ldconfig"
ln -s "$moved/romascope" "$elsewhere/bin/romascope"
away PATH="$elsewhere/bin:/usr/bin:/bin" "$elsewhere/bin/romascope" --version >/dev/null ||
    fail "the program does not start with all libraries from the folder"
echo "bundle: runs from another folder, $(wc -l <<<"$libraries") libraries checked"
