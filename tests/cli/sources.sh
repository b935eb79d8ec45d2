# Checks that the long test of CalculiX reads the machine's package sources, in either form, and adds source packages.
. tests/cli/expect.inc
. tests/calculix/sources.inc
mkdir -p "$work/etc/sources.list.d"
copy_sources "$work/etc" "$work/none"
expect 'no sources' 0 "$work/none
$work/none/sources.list
$work/none/sources.list.d" '' sh -c "find '$work/none' | sort"
cat > "$work/etc/sources.list" <<'L'
# the mirror of the house
deb [signed-by=/usr/share/keyrings/house.gpg] http://mirror.invalid/debian stable main
deb-src [signed-by=/usr/share/keyrings/house.gpg] http://mirror.invalid/debian stable main
L
echo 'deb	cdrom:[disc]/ stable main' > "$work/etc/sources.list.d/disc.list"
cat > "$work/etc/sources.list.d/house.sources" <<'L'
Types: deb
URIs: http://mirror.invalid/debian http://proxy.invalid:3142/debian
Suites: stable
Components: main
Signed-By:
 -----BEGIN PGP PUBLIC KEY BLOCK-----
 .
 Types: of key
 -----END PGP PUBLIC KEY BLOCK-----

types: deb-src
URIs: http://other.invalid/debian
Suites: stable
Components: main
L
echo 'deb http://off.invalid/debian stable main' > "$work/etc/sources.list.d/off.list.disabled"
copy_sources "$work/etc" "$work/copy"
expect 'lines' 0 'deb [signed-by=/usr/share/keyrings/house.gpg] http://mirror.invalid/debian stable main
deb-src [signed-by=/usr/share/keyrings/house.gpg] http://mirror.invalid/debian stable main' '' cat "$work/copy/sources.list"
expect 'lines of a part' 0 'deb	cdrom:[disc]/ stable main
deb-src	cdrom:[disc]/ stable main' '' cat "$work/copy/sources.list.d/disc.list"
expect 'paragraphs' 0 "$(sed 's/^[Tt]ypes:.*/Types: deb deb-src/' "$work/etc/sources.list.d/house.sources")" '' \
    cat "$work/copy/sources.list.d/house.sources"
expect 'and nothing else' 0 'disc.list
house.sources' '' ls "$work/copy/sources.list.d"
grep -nE '(https?|ftp)://[a-z0-9.-]*\.[a-z]' tests/long/*.sh tests/timed/*.sh tests/calculix/* Makefile .ci/run | grep -vE '\.invalid' > "$work/log"
[ ! -s "$work/log" ]; good=$?
[ $good = 0 ] || sed 's/^/# /' "$work/log"
report $((!good)) 'no script names a host'
