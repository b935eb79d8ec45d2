# The report, and the page of a mesh of one's own, in a real browser at the widths of a desk and of a telephone: no picture
# is missing, nothing is cut off, letters have 9 pixels and do not lie on each other.
. tests/cli/expect.inc
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
if [ -z "$browser" ] || ! command -v gnuplot > /dev/null; then
    echo 'ok 1 - the report # SKIP no chromium, or no gnuplot (Debian: chromium, gnuplot-nox)'
    exit 0
fi
sed 's/^heldout.*/heldout = 2000;/; s/^training.*/training = 1000;/' evolve/scenes/quad4.scene > "$work/quad4.scene"
BIN=$BIN BENCH_OPTIONS="--quiet --rounds 3 --scene $work/quad4.scene" sh tests/report/report.sh "$work/report" > "$work/log" 2>&1
good=$?
[ $good = 0 ] || sed 's/^/# /' "$work/log"
report $((!good)) 'is made'
# What the browser makes of it, as a line that it writes into the page.
cat >> "$work/report/index.html" << 'END'
<script>
addEventListener('load', () => {
    document.querySelectorAll('details').forEach(d => d.open = true)
    const images = [...document.images], missing = images.filter(i => !i.complete || i.naturalWidth == 0)
    const cut = [...document.body.querySelectorAll('*')].filter(e => !e.closest('.wide') &&
        e.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
    const broken = [...document.querySelectorAll('a[href^="#"]')].filter(a => !document.querySelector(CSS.escape ?
        '#' + CSS.escape(a.getAttribute('href').slice(1)) : a.getAttribute('href')))
    const faint = images.filter(i => i.clientWidth * 10.5 < i.naturalWidth * 9) // the smallest letters have 10.5 pixels
    const wide = images.filter(i => !i.src.includes('-map') && i.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
    const order = ['loses', 'hard', 'times', 'machines'].map(id => document.getElementById(id).getBoundingClientRect().top)
    const sorted = order[0] < 200 && order.every((top, i) => i == 0 || top > order[i - 1])
    document.title = ['seen', innerWidth, images.length, missing.length, cut.length, broken.length, faint.length, wide.length, sorted,
        cut.slice(0, 3).map(e => e.tagName + e.className)].join(' ')
})
</script>
END
see() { # see PAGE: the title that it has in the end
    "$browser" --headless --no-sandbox --disable-gpu --allow-file-access-from-files --virtual-time-budget=20000 \
        --window-size=1400,9100 --dump-dom "file://$1" 2> /dev/null | sed -n 's/.*<title>\(.*\)<\/title>.*/\1/p'
}
for width in 1280 400; do
    # A window is 500 pixels wide at least: the page is shown in a frame of the width.
    echo "<!DOCTYPE html><body style='margin:0'><iframe src='report/index.html' width=$width height=9000
        onload='setTimeout(() => document.title = frames[0].document.title, 1000)'></iframe>" > "$work/frame.html"
    seen=$(see "$work/frame.html")
    echo "# $seen"
    set -- $seen
    [ "$1" = seen ] && [ "$2" = $width ] && [ "$3" -ge 6 ] && [ "$4" = 0 ]; report $((! $?)) "$width pixels: pictures"
    [ "$5" = 0 ]; report $((! $?)) "$width pixels: nothing is cut off"
    [ "$6" = 0 ]; report $((! $?)) "$width pixels: links within the page"
    [ "$7" = 0 ]; report $((! $?)) "$width pixels: letters of pictures have 9 pixels"
    [ "$8" = 0 ]; report $((! $?)) "$width pixels: pictures fit, maps scroll"
    [ "$9" = true ]; report $((! $?)) "$width pixels: losses on the first screen, then hard cases, times, machines"
done

awk -v what=wavy -f tests/meshes/own.awk > "$work/own.inp"
echo 'training = 2000; heldout = 4000; mesh: { file = "own.inp"; };' > "$work/own.scene"
"$BIN/footpoint-evolve" --quiet --islands 1 --population 100 --scene "$work/own.scene" --generations 2 -o "$work/own.gen" \
    --page "$work/own.svg" > "$work/log" 2>&1
report $((! $?)) 'the page of a mesh is made'
for width in 1280 400; do
    cat > "$work/frame.html" << END
<!DOCTYPE html><body style='margin:0'><iframe src=own.svg width=$width height=900 style='border:0' onload='look(frames[0])'></iframe>
<script>
function look(frame) {
    const words = [...frame.document.querySelectorAll('text')], box = words.map(t => t.getBoundingClientRect())
    const small = words.filter(t => t.getScreenCTM().a * parseFloat(frame.getComputedStyle(t).fontSize) < 9)
    const cut = box.filter(b => b.left < 0 || b.top < 0 || b.right > frame.innerWidth || b.bottom > frame.innerHeight)
    const on = words.filter((t, i) => box.some((c, k) => k > i && box[i].left < c.right && c.left < box[i].right &&
        box[i].top < c.bottom && c.top < box[i].bottom))
    document.title = ['seen', frame.innerWidth, words.length, small.length, cut.length, on.length,
        on.slice(0, 3).map(t => t.textContent)].join(' ')
}
</script>
END
    seen=$(see "$work/frame.html")
    echo "# $seen"
    set -- $seen
    [ "$1" = seen ] && [ "$2" = $width ] && [ "$3" -gt 50 ] && [ "$4" = 0 ]; report $((! $?)) "$width pixels: letters of the mesh's page"
    [ "$5" = 0 ] && [ "$6" = 0 ]; report $((! $?)) "$width pixels: none are cut off or on others"
done
