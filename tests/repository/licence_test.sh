#!/usr/bin/env bash
# Only .reuse/dep5 states the licence of the files. No file states another one, and the README agrees.
set -euo pipefail
cd "$DELABOLE_SOURCE"
failed=0
stated=$(sed -n 's/^License: //p' .reuse/dep5)
if [[ $(grep -c '^Files: ' .reuse/dep5) != 1 || $(sed -n 's/^Files: //p' .reuse/dep5) != '*' || $stated != *[![:space:]]* ]]; then
    echo ".reuse/dep5 should state one licence for all files"
    failed=1
fi
if ! grep -qF "SPDX-License-Identifier: $stated" README.md; then
    echo "README.md does not say: $stated"
    failed=1
fi
if grep -rIn 'SPDX-License-Identifier' --exclude-dir=build --exclude-dir=.git --exclude-dir=repository . | grep -vF "$stated"; then
    echo "states another licence than .reuse/dep5, which should then except it"
    failed=1
fi
version=$(sed -n 's/^project(delabole VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
if ! grep -qF "license: $stated" CITATION.cff || ! grep -qF "version: $version" CITATION.cff; then
    echo "CITATION.cff does not give the licence $stated and the version $version"
    failed=1
fi
if ! grep -q 'GNU GENERAL PUBLIC LICENSE' LICENSE; then
    echo "LICENSE is not the text of $stated"
    failed=1
fi
exit "$failed"
