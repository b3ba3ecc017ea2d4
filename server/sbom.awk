# Lines of server/image.sh, one a package, as an SPDX 2.3 document (https://spdx.github.io/spdx-spec).
# link, name, version, architecture, source, source's version, licence

function id(name) { gsub(/[^A-Za-z0-9.-]/, "-", name); return "SPDXRef-" name }
function encoded(text) { gsub(/\+/, "%2B", text); gsub(/:/, "%3A", text); return text }

function package_(name, version, licence, purl, more) {
  printf "%s\n    {\"SPDXID\": \"%s\", \"name\": \"%s\", \"versionInfo\": \"%s\",\n", comma, id(name), name, version
  printf "     \"licenseConcluded\": \"NOASSERTION\", \"licenseDeclared\": \"%s\",\n", licence
  printf "     \"copyrightText\": \"NOASSERTION\", \"downloadLocation\": \"NOASSERTION\",\n"
  printf "     \"filesAnalyzed\": false, %s,\n", more
  printf "     \"externalRefs\": [{\"referenceCategory\": \"PACKAGE-MANAGER\", \"referenceType\": \"purl\",\n"
  printf "                       \"referenceLocator\": \"%s\"}]}", purl
  comma = ","
}

function relation(from, type, to) {
  return sprintf("    {\"spdxElementId\": \"%s\", \"relationshipType\": \"%s\", \"relatedSpdxElement\": \"%s\"}",
                 from, type, to)
}

BEGIN {
  split(os_release, os, " ")
  printf "{\n  \"spdxVersion\": \"SPDX-2.3\", \"dataLicense\": \"CC0-1.0\", \"SPDXID\": \"SPDXRef-DOCUMENT\",\n"
  printf "  \"name\": \"tia-%s\", \"documentNamespace\": \"https://spdx.org/spdxdocs/tia-%s-%s\",\n", version, version, sha256
  printf "  \"creationInfo\": {\"created\": \"%s\", \"creators\": [\"Tool: tia-image-%s\"]},\n", created, version
  printf "  \"packages\": ["
  package_("tia", version, "MIT", "pkg:generic/tia@" version,
           "\"primaryPackagePurpose\": \"APPLICATION\", \"checksums\": [{\"algorithm\": \"SHA256\", \"checksumValue\": \"" sha256 "\"}]")
  relations = relation("SPDXRef-DOCUMENT", "DESCRIBES", id("tia"))
}

{
  package_($2, $3, $7,
           "pkg:deb/" os[1] "/" encoded($2) "@" encoded($3) "?arch=" $4 "&distro=" os[1] "-" os[2],
           "\"primaryPackagePurpose\": \"LIBRARY\", \"supplier\": \"Organization: Debian\", \"sourceInfo\": \"built from " $5 " " $6 "\"")
  relations = relations ",\n" relation(id("tia"), $1, id($2))
}

END { printf "\n  ],\n  \"relationships\": [\n%s\n  ]\n}\n", relations }
