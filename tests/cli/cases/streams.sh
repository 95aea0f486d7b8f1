# Damaged streams end with exit code 1, and write nothing.
cube cube.obj
quiet encode cube.obj good.dmsh
: >empty.dmsh
printf 'ply\nformat ascii 1.0\n' >text.dmsh
head -c 61 good.dmsh >short.dmsh
cp good.dmsh long.dmsh && printf 'x' >>long.dmsh
size=$(stat -c %s good.dmsh)
cp good.dmsh flipped.dmsh
printf '\xa5' | dd of=flipped.dmsh bs=1 seek=$((size - 9)) conv=notrunc status=none
for file in empty text short long; do
  for command in "decode $file.dmsh out.ply" "info $file.dmsh" "verify $file.dmsh" "compare cube.obj $file.dmsh"; do
    status $command
    grep -q "^deltamesh: .*$file.dmsh: " .err || say "no message"
  done
done
status verify flipped.dmsh
status decode flipped.dmsh out.ply
status verify good.dmsh
list
