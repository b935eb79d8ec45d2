# Checks that `make dist` packs the committed files, to the same bytes everywhere, and that packagers' files agree with the release.
. tests/cli/expect.inc
unset MAKEFLAGS MAKELEVEL MFLAGS
version=$(sed -n 's/^.define FOOTPOINT_VERSION "\(.*\)"/\1/p' codegen/base/base.h)

# ---- the archive ----
if git rev-parse -q --verify HEAD > /dev/null 2>&1; then
    git clone -q . "$work/clone" && archive=$work/clone/build/footpoint-$version.tar.gz
    expect 'make dist' 0 '' '' make -s -C "$work/clone" dist
    mv "$archive" "$work/first.tar.gz"
    touch "$work/clone/generated/footpoint_mine.h"
    expect 'elsewhere in the world, beside a file of one'\''s own' 0 '' '' \
        sh -c "umask 077; TZ=Asia/Tokyo LC_ALL=C make -s -C '$work/clone' dist"
    expect 'gives the same bytes' 0 '' '' cmp "$work/first.tar.gz" "$archive"
    git ls-tree -r --name-only HEAD | sed "s|^|footpoint-$version/|" | sort > "$work/committed"
    tar tzf "$archive" | grep -v '/$' | sort > "$work/packed"
    expect 'all that is committed, and nothing else' 0 '' '' diff "$work/committed" "$work/packed"
else
    report 1 'skipped: no git'
fi

# ---- the release ----
expect 'the release has its entry under Changes' 0 "$version:" '' sh -c "sed '1,/^## Changes/d' runtime/README.md | grep -m 1 '^[0-9.]*:'"
if command -v dpkg-parsechangelog > /dev/null; then
    expect "Debian's changelog" 0 "$version-1" '' \
        dpkg-parsechangelog -l runtime/package/debian/changelog -S Version
else
    report 1 'skipped: no dpkg-parsechangelog'
fi
abi=$(sed -n 's/^FOOTPOINT_\([0-9]*\) {/\1/p' runtime/package/footpoint.map)
for file in libfootpoint$abi.install libfootpoint$abi.symbols; do
    [ -s runtime/package/debian/$file ]; report $((! $?)) "Debian's package of the library has the interface's number: $file"
done

# ---- Spack: the recipe, with stand-ins for Spack's modules, names targets that exist ----
if command -v python3 > /dev/null; then
    mkdir "$work/spack" && cat > "$work/spack/package.py" <<'P'
class MakefilePackage:
    prefix = "/opt/footpoint"


class Spec:
    def __init__(self, text):
        self.text = text

    def satisfies(self, text):
        return text in self.text


def license(name): ...
def version(number): print(number)
def variant(name, default, description): ...
def depends_on(name, type): ...
P
    cat > "$work/recipe.py" <<'P'
import importlib.util
import sys

found = importlib.util.spec_from_file_location("recipe", sys.argv[1])
recipe = importlib.util.module_from_spec(found)
found.loader.exec_module(recipe)
from spack.package import Spec

for text in "footpoint", "footpoint+openmp":
    package = recipe.Footpoint()
    package.spec = Spec(text)
    print(*package.build_targets)
    print(*package.install_targets)
P
    expect "Spack's recipe" 0 "$version
runtime
install-runtime PREFIX=/opt/footpoint
runtime OPENMP=1
install-runtime PREFIX=/opt/footpoint OPENMP=1" '' \
        env PYTHONPATH="$work" PYTHONDONTWRITEBYTECODE=1 python3 "$work/recipe.py" runtime/package/spack/package.py
    tail -n +2 "$work/stdout" > "$work/targets"
    while read -r targets; do
        expect "make $targets" 0 '*' '' make -n $targets
    done < "$work/targets"
else
    report 1 'skipped: no python3'
fi
