#!/usr/bin/env bash
# Puts small faults into a clone of this checkout, one at a time, and lists those that no test detects.
#
#   tests/mutants/run.sh                    all faults of faults.txt
#   tests/mutants/run.sh random_cracks      those with this in their file or texts
#   tests/mutants/run.sh --check            only checks whether every fault fits the source
#   tests/mutants/run.sh --clone DIR ...    uses that clone, with its build in build/release
#
# By default the clone is build/mutants, of the last commit; it and its build are kept, so that a
# fault costs two compilations of one file and a link or two. Exit code 1 if a fault was not detected,
# 2 if one could not be tried.
set -euo pipefail
here=$(cd "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
list=$here/tests/mutants/faults.txt
clone=$here/build/mutants
own_clone=true check=false pattern=
while [ $# -gt 0 ]; do
  case $1 in
    --check) check=true ;;
    --clone) clone=$(cd "$2" && pwd) own_clone=false; shift ;;
    -*) echo "usage: run.sh [--check] [--clone DIR] [PATTERN]" >&2; exit 2 ;;
    *) pattern=$1 ;;
  esac
  shift
done
[ "$clone" != "$here" ] || { echo "the faults go into a clone, not into this checkout" >&2; exit 2; }

seen=0 unseen=0 untried=0
declare -A passes=()  # what was tried without a fault: ok or bad

# Returns whether `text` contains `part` exactly once.
once() {
  local text=$1 part=$2
  local rest=${text#*"$part"}
  [ "$rest" != "$text" ] && [[ $rest != *"$part"* ]]
}

could_not() {
  untried=$((untried + 1))
  echo "UNTRIED   $1: ${was%%$'\n'*}: $2"
}

# The code with faults is built file by file, the tests in large units: both take little time.
configure() {
  local -a options=(-DCMAKE_UNITY_BUILD=OFF -DHACKLE_UNITY_TESTS=ON -DHACKLE_AVX512=OFF "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG")
  command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  (cd "$clone" && cmake --preset release "${options[@]}" >/dev/null)
}

build_tests() {
  local -a targets=()
  local entry
  for entry in $tests; do targets+=(--target "test_${entry%%:*}"); done
  nice -n 19 cmake --build "$clone/build/release" "${targets[@]}" >"$clone/build/mutants.log" 2>&1
}

# Returns success if every named test passes and at least one exists.
pass_tests() {
  local entry said
  for entry in $tests; do
    said=$(cd "$clone" && nice -n 19 timeout 600 "build/release/bin/test_${entry%%:*}" \
      "--gtest_filter=${entry#*:}" --gtest_brief=1 --gtest_fail_fast 2>&1) || return 1
    [[ $said != *" 0 tests from "* ]] || return 1
  done
}

passes_without_fault() {
  if [ -z "${passes[$tests]:-}" ]; then
    passes[$tests]=bad
    if build_tests && pass_tests; then passes[$tests]=ok; fi
  fi
  [ "${passes[$tests]}" = ok ]
}

try_fault() {
  local path=$clone/$file text
  text=$(<"$path")
  passes_without_fault || { could_not "$file" "the tests fail without it"; return; }
  printf '%s\n' "${text%%"$was"*}$now${text#*"$was"}" >"$path"
  local state=seen
  if ! build_tests; then
    state=untried
  elif pass_tests; then
    state=unseen
  fi
  git -C "$clone" checkout --quiet -- "$file"
  case $state in
    untried) could_not "$file" "it does not compile" ;;
    seen) seen=$((seen + 1)); echo "seen      $file: ${was%%$'\n'*}" ;;
    unseen) unseen=$((unseen + 1)); echo "NOT SEEN  $file: ${was%%$'\n'*}  ->  ${now%%$'\n'*}" ;;
  esac
}

take() {
  [ -n "$file" ] || return 0
  [[ "$file $was $now" == *"$pattern"* ]] || return 0
  local root=$clone
  if $check; then root=$here; fi
  if [ ! -f "$root/$file" ]; then could_not "$file" "there is no such file"
  elif ! once "$(<"$root/$file")" "$was"; then could_not "$file" "the text is not there exactly once"
  elif [ "$was" = "$now" ] || [ -z "$tests" ]; then could_not "$file" "it is no fault, or names no tests"
  elif $check; then seen=$((seen + 1))
  else try_fault
  fi
}

if ! $check && $own_clone; then
  [ -d "$clone/.git" ] || git clone --quiet "$here" "$clone"
  git -C "$clone" fetch --quiet origin HEAD
  git -C "$clone" checkout --quiet --force --detach FETCH_HEAD
  [ -f "$clone/build/release/build.ninja" ] || configure
fi
if ! $check; then
  git -C "$clone" diff --quiet -- src assets || {
    echo "the clone has changes of its own in src or assets, which would be lost" >&2
    exit 2
  }
  trap 'git -C "$clone" checkout --quiet -- src assets' EXIT
fi

file= was= now= tests=
while IFS= read -r line || [ -n "$line" ]; do
  key=${line%% *} value=${line#"${line%% *}"}
  value=${value# }
  case $key in
    '') take; file= was= now= tests= ;;
    '#') ;;
    file) file=$value ;;
    was) was=${was:+$was$'\n'}$value ;;
    now) now=${now:+$now$'\n'}$value ;;
    tests) tests=$value ;;
    *) echo "faults.txt: what is '$line'?" >&2; exit 2 ;;
  esac
done <"$list"
take

if $check; then
  echo "$seen faults fit the source, $untried do not"
else
  echo "$seen seen, $unseen not seen, $untried could not be tried"
fi
if [ $((seen + unseen + untried)) -eq 0 ]; then echo "no fault has '$pattern' in it" >&2; exit 2; fi
if [ "$untried" -gt 0 ]; then exit 2; fi
if [ "$unseen" -gt 0 ]; then exit 1; fi
