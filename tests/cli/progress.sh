# Checks that make prints a line for each file on stderr; V=1 prints commands, -s nothing.
. tests/cli/expect.inc
object=$work/o/codegen/base/text.o
built() { rm -f "$object"; MAKEFLAGS='' MFLAGS='' MAKELEVEL='' make --no-print-directory "$@" CC="${CC:-gcc}" OBJ="$work/o" "$object"; }
expect 'a line for each file' 0 '' '  CC   codegen/base/text.c' built
[ -s "$object" ]; report $((! $?)) 'which is made'
expect 'silent' 0 '' '' built -s
expect 'commands' 0 '*' '' built V=1
grep -q "^${CC:-gcc} .* codegen/base/text.c -o $object$" "$work/stdout"; report $((! $?)) 'are shown'
