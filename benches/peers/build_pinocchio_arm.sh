#!/usr/bin/env bash
# Compiles pinocchio_arm.cpp against the headers of the pip package `pin` and Debian's libeigen3-dev; two minutes.
#
#   build_pinocchio_arm.sh PYTHON OUTPUT [FLAG ...]     FLAG: -march=native and the like
set -euo pipefail
cd "$(dirname "$0")"
python=$1 output=$2
shift 2
prefix=$("$python" -c "import sysconfig; print(sysconfig.get_paths()['purelib'])")/cmeel.prefix
g++ -O3 -DNDEBUG -std=c++17 -w -DBOOST_MPL_LIMIT_LIST_SIZE=30 -DBOOST_MPL_LIMIT_VECTOR_SIZE=30 \
  -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS -DBOOST_FUSION_INVOKE_MAX_ARITY=12 "$@" \
  -I"$prefix/include" -I/usr/include/eigen3 pinocchio_arm.cpp -o "$output" \
  -L"$prefix/lib" -lpinocchio_default -lboost_serialization -Wl,-rpath,"$prefix/lib"
