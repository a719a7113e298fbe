#!/bin/bash
# make.sh BUILD FOLDER: what was built in BUILD as a relocatable FOLDER, which is made anew.
#   romascope            starts the program (launcher.sh)
#   bin/ share/          the program and the scenes; shaders are inside the program
#   lib/                 libraries it needs, except the C library and GL drivers
#   lib/cxx/ lib/x11/    those that a GL driver shares with it; see launcher.sh
#   licences/            of everything that is inside
set -euo pipefail
build=$1 folder=$2
here=$(dirname "$(readlink -f "$0")")

# The C library and its loader come with the machine and fit its kernel and GL driver only there.
of_the_machine='^(ld-linux.*|lib(c|m|dl|pthread|rt|resolv|util|GL|GLX|EGL|OpenGL|GLdispatch)\.so.*)$'

rm -rf "$folder"
cmake --install "$build" --prefix "$folder" --strip >/dev/null
mkdir -p "$folder"/lib/{cxx,x11} "$folder/licences"
install -m 755 "$here/launcher.sh" "$folder/romascope"
install -m 644 "$here/README.txt" "$folder/README.txt"
mv "$folder/share/doc/romascope/LICENSE" "$folder/licences/romascope"
rm -r "$folder/share/doc"

# Compiled into the program: glm, CLI11, nlohmann-json, Dear ImGui, and the loader that glad wrote.
packages=(libglm-dev libcli11-dev nlohmann-json3-dev python3-glad libimgui-dev)
while read -r name path; do
    [[ $name =~ $of_the_machine ]] && continue
    case $name in
    libstdc++.* | libgcc_s.*) place=lib/cxx ;;
    libX* | libxcb* | libbsd.* | libmd.*) place=lib/x11 ;;
    *) place=lib ;;
    esac
    real=$(readlink -f "$path")
    install -m 644 "$real" "$folder/$place/"
    strip --strip-unneeded "$folder/$place/${real##*/}"
    [ "${real##*/}" = "$name" ] || ln -s "${real##*/}" "$folder/$place/$name"
    # Packages name some files by the path before /lib became a link to /usr/lib.
    owner=$(dpkg-query -S "$real" 2>/dev/null || dpkg-query -S "${real#/usr}")
    packages+=("${owner%%:*}")
done < <(ldd "$build/bin/romascope" | awk '$2 == "=>" { print $1, $3 }')
for package in "${packages[@]}"; do
    cp -L "/usr/share/doc/$package/copyright" "$folder/licences/$package"
done
