# Reads the contact decks of CalculiX's tests in Debian. Each is read, or refused for its master faces; none is refused
# for an element, a surface or a keyword that contact does not need. A scene for each, without a kind of segment, must
# detect the kind. DECKS=FOLDER keeps them between runs.
. tests/cli/expect.inc
folder=${DECKS:-$work/decks}
skip() { echo "ok 1 - # skip $1"; exit 0; }
for tool in apt-get dpkg zcat; do
    command -v $tool > /dev/null || skip "no $tool"
done

fetch() {
    apt-get -qq -o APT::Sandbox::User=root download calculix-ccx-test && dpkg -x calculix-ccx-test_*.deb root
}
mkdir -p "$folder" || exit 3
[ -e "$folder/root" ] || (cd "$folder" && fetch) > "$work/fetch" 2>&1 || skip "no decks: $(tail -n 1 "$work/fetch")"

mkdir "$work/contact"
find "$folder/root" -name '*.inp*' | sort | while read -r file; do
    deck=$work/contact/$(basename "${file%.gz}")
    case $file in *.gz) zcat "$file" ;; *) cat "$file" ;; esac > "$deck"
    grep -qi '^\*contact *pair' "$deck" || rm "$deck"
done
total=$(ls "$work/contact" | wc -l)
[ "$total" -ge 40 ]; report $((! $?)) "$total decks with contact pairs"

# As a scene reads them; samples need slave nodes within the distance, which a model of one element may not have.
for deck in "$work/contact"/*.inp; do
    {
        echo 'training = 10; heldout = 10;'
        echo 'mesh: { file = "'"$deck"'"; };'
        echo 'frame = "none"; tiers = ({ name = "t"; terminals = ["x"]; max_length = 1; functions = "polynomial"; });'
    } > "$work/deck.scene"
    "$BIN/footpoint-evolve" --scene "$work/deck.scene" --generations 0 -o "$work/deck.gen" 2>&1 | grep -v -e '^\[hwloc' -e ': note: ' |
        sed "s|$work/contact/||; s|$work/||"
done > "$work/said"
read=$(grep -c "no frame 'none'" "$work/said")
kinds=$(grep -c 'master faces are of several kinds' "$work/said")
edges=$(grep -c 'master faces are edges of plane elements' "$work/said")
faces=$(grep -c 'of a master surface has type' "$work/said")
grep -v "no frame 'none'" "$work/said" | sed 's/^/# /'
echo "# $((read + kinds + edges)) read, $kinds of them with faces of several kinds, $edges with edges; $faces refused for their master faces"
[ "$(wc -l < "$work/said")" = "$total" ] && [ $((read + kinds + edges + faces)) = "$total" ] && [ "$faces" -le 5 ]
report $((! $?)) 'each is read, or refused for its master faces'
