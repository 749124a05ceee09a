#!/bin/sh
# Proves with gappa that rounding keeps to the bounds which the kernels state, for each polynomial and number: a line each, with the
# bound.
# usage: proofs.sh [--self-test] FIT_KERNELS COEFFICIENTS FOLDER
#        FIT_KERNELS   the program; it writes the proofs of the polynomials in the file COEFFICIENTS into FOLDER
#        --self-test   instead, proofs of lower bounds and of wider domains, all of which must fail
# exit status: 0 all is proven; 1 something is not; 77 gappa is missing (Debian gappa)
set -eu
self_test=false
if [ "${1-}" = --self-test ]; then
  self_test=true
  shift
fi
[ $# -eq 3 ] || {
  echo "usage: proofs.sh [--self-test] FIT_KERNELS COEFFICIENTS FOLDER" >&2
  exit 1
}
fit_kernels=$1
coefficients=$2
folder=$3
command -v gappa >/dev/null 2>&1 || {
  echo "skipped: the proofs need gappa (Debian gappa)"
  exit 77
}
rm -rf "$folder"
"$fit_kernels" --gappa "$coefficients" "$folder"

# proven FILE: 140 bits are enough for an extended's 64. What gappa says is kept in FILE.said.
proven() {
  gappa -Eprecision=140 "$1" >"$1.said" 2>&1
}

# changed NAME SED_PROGRAM: a proof with another text, which must not hold.
faults=0
changed() {
  sed "$2" "$folder/$1.g" >"$folder/changed.g"
  if cmp -s "$folder/$1.g" "$folder/changed.g" || proven "$folder/changed.g"; then
    echo "FAIL: $1 holds after $2"
    faults=$((faults + 1))
  elif ! grep -q 'properties were not satisfied' "$folder/changed.g.said"; then
    echo "FAIL: $1 after $2 is not what gappa can read:"
    cat "$folder/changed.g.said"
    faults=$((faults + 1))
  else
    echo "fails, as it should: $1 after $2"
  fi
}
if $self_test; then
  bound='<= [0-9]*b-[0-9]* }'
  changed ArcTangent_9_float "s/$bound/<= 3b-26 }/"          # 0.375 epsilon instead of 0.51
  changed ArcTangent_9_float 's/t in \[0,1\]/t in [0,2]/'    # beyond the fit's domain
  changed ArcTangent_5_float 's/^c3 = .*/c3 = -7275b-29;/'   # a coefficient, off by 1e-5 of itself
  changed ArcCosine_11_float 's/y in \[0,1\]/y in [-1,1]/'
  changed Logarithm_8_double "s/$bound/<= 1b-53 }/"
  changed SrgbCurve_3_float "s/$bound/<= 1b-18 }/"
  changed OctantSteps_float "s/$bound/<= 3b-27 }/"
  changed FromAxis_double "s/$bound/<= 1b-53 }/"
  [ "$faults" -eq 0 ]
  exit
fi

count=0
for file in "$folder"/*.g; do
  count=$((count + 1))
  text=$(sed -n '1s/^# //p' "$file")
  if proven "$file"; then
    echo "proven: $text"
  else
    echo "FAIL: $text"
    cat "$file.said"
    faults=$((faults + 1))
  fi
done
echo "$((count - faults)) of $count proofs hold"
[ "$faults" -eq 0 ]
