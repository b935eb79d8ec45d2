# Checks Debian's packages made from the archive of `make dist`: they build, lintian finds no error, and a program
# compiles and runs with their contents. Installs nothing.
. tests/cli/expect.inc
unset MAKEFLAGS MAKELEVEL MFLAGS
CC=${CC:-gcc}
skip() { echo "ok 1 - # skip $1"; exit 0; }
for tool in git dpkg-buildpackage dh lintian; do
    command -v $tool > /dev/null || skip "no $tool"
done
git rev-parse -q --verify HEAD > /dev/null 2>&1 || skip 'no git'
version=$(sed -n 's/^.define FOOTPOINT_VERSION "\(.*\)"/\1/p' codegen/base/base.h)
git clone -q . "$work/clone" && make -s -C "$work/clone" dist &&
    mv "$work/clone/build/footpoint-$version.tar.gz" "$work/footpoint_$version.orig.tar.gz" && cd "$work" &&
    tar xf "footpoint_$version.orig.tar.gz" && cd "footpoint-$version" && cp -r runtime/package/debian debian &&
    DEB_BUILD_OPTIONS='parallel=2 noautodbgsym' dpkg-buildpackage -b -us -uc > "$work/log" 2>&1
good=$?
[ $good = 0 ] || tail -n 20 "$work/log" | sed 's/^/# /'
report $((! good)) 'packages build'
cd "$work" || exit 3
expect 'lintian finds no error' 0 '' '*' lintian --allow-root --fail-on error --tag-display-limit 0 -q --show-overrides -L '>=error' footpoint_*.changes
for package in *.deb; do dpkg -x "$package" root; done
cat > use.c <<'C'
#include <footpoint.h>
#include <footpoint/footpoint_quad4.h>
#include <stdio.h>
int main(void)
{
    puts(footpoint_strerror(FOOTPOINT_OK));
    return 0;
}
C
folder=$(dirname root/usr/lib/*/libfootpoint.so)
expect 'a program compiles with them' 0 '' '' sh -c "$CC use.c -o use \
    $(PKG_CONFIG_PATH=$work/$folder/pkgconfig pkg-config --cflags --libs footpoint) -lm"
expect 'and runs with the library alone' 0 success '' env LD_LIBRARY_PATH="$folder" ./use
expect 'the tools find their scenes' 0 '*' '*' root/usr/bin/footpoint-evolve --scene tri3 --generations 0 --quiet
