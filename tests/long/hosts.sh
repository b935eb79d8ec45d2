# Runs three network namespaces as separate hosts, with their own names and addresses and a slow link. Genomes and log
# must be the same as on one host; a lost host costs only the work since the last checkpoint.
. tests/cli/expect.inc
evolve=$(cd "$BIN" && pwd)/footpoint-evolve
id=fp$$ net=10.$((100 + $$ % 100)).$(($$ / 100 % 250))
skip() { echo "ok 1 - # skip $1"; exit 0; }
[ "$(id -u)" = 0 ] || skip 'namespaces need root'
[ -n "$(command -v ip)" ] && [ -n "$(command -v unshare)" ] || skip 'no ip or unshare'
ip netns add ${id}a 2> /dev/null || skip 'no network namespaces here'
close() {
    ip link del $id 2> /dev/null
    for h in a b c; do ip netns del $id$h 2> /dev/null; done
    rm -rf "$work"
}
trap close EXIT
ip netns add ${id}b && ip netns add ${id}c && ip link add $id type bridge 2> /dev/null && ip addr add $net.1/24 dev $id &&
    ip link set $id up || skip 'no bridges here'
n=1
for h in a b c; do
    n=$((n + 1))
    ip link add $id$h type veth peer name eth0 netns $id$h && ip link set $id$h master $id up &&
        ip -n $id$h addr add $net.$n/24 dev eth0 && ip -n $id$h link set eth0 up && ip -n $id$h link set lo up ||
        skip 'no links between namespaces here'
    tc -n $id$h qdisc add dev eth0 root netem delay 2ms 2> /dev/null || echo '# the wire is fast: no netem'
done
ip netns exec ${id}a ping -c 1 -W 2 $net.4 > /dev/null 2>&1 || [ -z "$(command -v ping)" ] || skip 'namespaces hear nothing'

# What mpirun takes for ssh: AGENT HOST COMMAND...
cat > "$work/agent" << AGENT
#!/bin/sh
case \$1 in $net.2) h=${id}a ;; $net.3) h=${id}b ;; *) h=${id}c ;; esac
shift
exec ip netns exec \$h unshare --uts sh -c "hostname \$h; \$*"
AGENT
chmod +x "$work/agent"
on_hosts() { # on_hosts RANKS ARGUMENTS...
    ranks=$1
    shift
    timeout 120 mpirun -q --allow-run-as-root --oversubscribe --host $net.2:2,$net.3:2,$net.4:2 -n "$ranks" --map-by node \
        --mca plm_rsh_agent "$work/agent" --mca plm_rsh_no_tree_spawn 1 --mca btl tcp,self --mca btl_tcp_if_include $net.0/24 \
        --mca oob_tcp_if_include $net.0/24 "$evolve" "$@"
}
cp tests/scenes/small.scene "$work/"
options="--scene $work/small.scene --seed 5 --from-scratch --islands 4 --population 60 --quiet"
"$evolve" $options --generations 100 -o "$work/whole.gen" --log "$work/whole.csv" > /dev/null 2>&1
for ranks in 3 5; do
    on_hosts $ranks $options --generations 100 -o "$work/h.gen" --log "$work/h.csv" > /dev/null 2> "$work/err"
    cmp -s "$work/whole.gen" "$work/h.gen" && cmp -s "$work/whole.csv" "$work/h.csv"
    report $((! $?)) "$ranks ranks on three hosts: the same genomes and log" || sed 's/^/# /' "$work/err"
    rm -f "$work/h.gen" "$work/h.csv"
done

# A host goes dark; the job does not end well by itself, and is ended by mpirun's or by our time limit.
on_hosts 3 $options --generations 100000 -o "$work/d.gen" --log "$work/d.csv" --checkpoint "$work/ck" --checkpoint-every 0.3 \
    > /dev/null 2>&1 &
pid=$!
tries=100
until [ -e "$work/ck" ] || [ $((tries -= 1)) = 0 ]; do sleep 0.1; done
sleep 1
ip link set ${id}b down
for h in a b c; do ip netns pids $id$h; done > "$work/pids"
sleep 2
kill -9 $(cat "$work/pids") 2> /dev/null; kill $pid 2> /dev/null
wait $pid 2> /dev/null
ip link set ${id}b up
generation=$(sed -n 's/^generation //p;/^scene /q' "$work/ck" 2> /dev/null | head -1)
[ "${generation:-0}" -gt 0 ]; report $((! $?)) "a host goes dark: a checkpoint of generation $generation is there"
on_hosts 4 --resume "$work/ck" --generations $((generation + 20)) --quiet > /dev/null 2>&1
"$evolve" $options --generations $((generation + 20)) -o "$work/e.gen" --log "$work/e.csv" > /dev/null 2>&1
cmp -s "$work/d.gen" "$work/e.gen" && cmp -s "$work/d.csv" "$work/e.csv"
report $((! $?)) 'and resumed to the same bytes'
