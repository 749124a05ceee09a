#!/bin/sh
# Proves with gappa that rounding keeps to the bounds which the kernels state, for each polynomial and number: a line each, with the
# bound.
# usage: proofs.sh FIT_KERNELS COEFFICIENTS FOLDER
#        FIT_KERNELS   the program; it writes the proofs of the polynomials in the file COEFFICIENTS into FOLDER
# exit status: 0 all is proven; 1 something is not; 77 gappa is missing (Debian gappa)
set -eu
[ $# -eq 3 ] || {
  echo "usage: proofs.sh FIT_KERNELS COEFFICIENTS FOLDER" >&2
  exit 1
}
command -v gappa >/dev/null 2>&1 || {
  echo "skipped: the proofs need gappa (Debian gappa)"
  exit 77
}
folder=$3
rm -rf "$folder"
"$1" --gappa "$2" "$folder"

count=0
faults=0
for file in "$folder"/*.g; do
  count=$((count + 1))
  if gappa -Eprecision=140 "$file" >"$file.said" 2>&1; then # 140 bits are enough for an extended's 64
    echo "proven: $(sed -n '1s/^# //p' "$file")"
  else
    faults=$((faults + 1))
    echo "FAIL: $(sed -n '1s/^# //p' "$file")"
    cat "$file.said"
  fi
done
echo "$((count - faults)) of $count proofs hold"
[ "$faults" -eq 0 ]
