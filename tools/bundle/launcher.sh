#!/bin/sh
# Starts romascope from wherever this folder lies.
# C++ and X11 libraries are shared with the machine's GL driver, which may need newer ones than these:
# the machine's own are taken unless it has none, or older ones.
here=$(dirname "$(readlink -f "$0")")
known=$(PATH="$PATH:/usr/sbin:/sbin" ldconfig -p 2>/dev/null)
extra=
theirs=$(printf '%s\n' "$known" | sed -n 's/.*libstdc++\.so\.6 (libc6,x86-64.*=> //p' | head -n 1)
[ -n "$theirs" ] && theirs=$(readlink -f "$theirs")
ours=$(readlink -f "$here/lib/cxx/libstdc++.so.6")
# The last number of libstdc++.so.6.0.30 is its version.
[ "${theirs##*.}" -ge "${ours##*.}" ] 2>/dev/null || extra=$here/lib/cxx
case $known in
*"libX11.so.6 (libc6,x86-64"*) ;;
*) extra=$extra${extra:+:}$here/lib/x11 ;;
esac
if [ -n "$extra" ]; then
    export LD_LIBRARY_PATH="$extra${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
fi
exec "$here/bin/romascope" "$@"
