#!/usr/bin/env bash
# What the programs are linked of, as SPDX 2.3 in JSON on standard output: Debian packages of the shared libraries, and of
# what is compiled in from headers.
#   packaging/sbom.sh VERSION PROGRAM…
set -euo pipefail
version=$1
shift

compiled_in=(libeigen3-dev nlohmann-json3-dev libcli11-dev libboost-math-dev)

# The packages of the shared libraries. /lib is /usr/lib here, and packages name the one or the other; what alternatives
# lead to has the name of its own file.
shared() {
    local file files=()
    while read -r file; do
        file=$(realpath "$file")
        files+=("$file" "${file#/usr}" "/usr$file")
    done < <(ldd "$@" | sed -n 's/.* => \(\/[^ ]*\) .*/\1/p' | sort -u)
    { dpkg-query -S "${files[@]}" 2>/dev/null || true; } | sed 's/: .*//; s/,.*//; s/:.*//' | sort -u
}
# The licences that a package's machine-readable copyright file names.
licence_of() {
    local names
    names=$(sed -n 's/^License:[[:space:]]*\([^[:space:]].*\)$/\1/p' "/usr/share/doc/$1/copyright" 2>/dev/null |
        sort -u | paste -sd ';' -)
    printf '%s' "${names:-NOASSERTION}" | tr '\t' ' ' | tr -d '"\\[:cntrl:]'
}
digest=$(sha256sum "$@" | sha256sum | cut -c1-32)

mapfile -t packages < <({ shared "$@"; printf '%s\n' "${compiled_in[@]}"; } | sort -u)
cat <<EOF
{
  "spdxVersion": "SPDX-2.3",
  "dataLicense": "CC0-1.0",
  "SPDXID": "SPDXRef-DOCUMENT",
  "name": "analogon-$version",
  "documentNamespace": "https://spdx.org/spdxdocs/analogon-$version-$digest",
  "creationInfo": {
    "created": "$(date -u -d "@${SOURCE_DATE_EPOCH:-$(date +%s)}" +%Y-%m-%dT%H:%M:%SZ)",
    "creators": ["Tool: analogon-sbom"]
  },
  "packages": [
    {
      "SPDXID": "SPDXRef-Package-analogon",
      "name": "analogon",
      "versionInfo": "$version",
      "downloadLocation": "NOASSERTION",
      "filesAnalyzed": false,
      "licenseConcluded": "GPL-3.0-only",
      "licenseDeclared": "GPL-3.0-only",
      "copyrightText": "NOASSERTION"
    }$(for package in "${packages[@]}"; do
    printf ',\n    {\n      "SPDXID": "SPDXRef-Package-%s",\n      "name": "%s",\n      "versionInfo": "%s",\n' \
        "${package//[^A-Za-z0-9.-]/-}" "$package" "$(dpkg-query -W -f='${Version}' "$package" | head -n 1)"
    printf '      "downloadLocation": "NOASSERTION",\n      "filesAnalyzed": false,\n'
    printf '      "licenseConcluded": "NOASSERTION",\n      "licenseDeclared": "NOASSERTION",\n'
    printf '      "licenseComments": "%s",\n      "copyrightText": "NOASSERTION",\n' "$(licence_of "$package")"
    printf '      "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": "pkg:deb/debian/%s@%s"}]\n    }' \
        "$package" "$(dpkg-query -W -f='${Version}' "$package" | head -n 1)"
done)
  ],
  "relationships": [
    {"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": "SPDXRef-Package-analogon"}$(for package in "${packages[@]}"; do
    kind=DYNAMIC_LINK
    [[ " ${compiled_in[*]} " != *" $package "* ]] || kind=STATIC_LINK
    printf ',\n    {"spdxElementId": "SPDXRef-Package-analogon", "relationshipType": "%s", "relatedSpdxElement": "SPDXRef-Package-%s"}' \
        "$kind" "${package//[^A-Za-z0-9.-]/-}"
done)
  ]
}
EOF
