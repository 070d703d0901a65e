#!/bin/bash
# Makes the Debian package, has lintian judge it, and installs it into a root of the same Debian that
# has nothing else: a study of an installed example runs there.
#
#   package.sh BUILD_FOLDER
#
# Exit code 77: skipped, as other_debian.sh.
set -euo pipefail
build=$(realpath "$1")
source "$(dirname "${BASH_SOURCE[0]}")/root.sh"
make_root "$(this_suite)"

(cd "$build" && cpack -G DEB -B "$work/package" >"$work/cpack.log") || { cat "$work/cpack.log"; exit 1; }
package=$(echo "$work"/package/*.deb)
if command -v lintian >/dev/null; then
  lintian --allow-root --fail-on error "$package"
fi

cp "$package" "$root/pedzone.deb"
cat >"$root/example.study.xml" <<'XML'
<study seeds="1-3" end="60">
  <scenario file="/usr/share/doc/pedzone/examples/scenarios/plaza/plaza-low.sumocfg"/>
</study>
XML
in_root bash -ec '
  apt-get -q -y install --no-install-recommends /pedzone.deb >/dev/null
  pedzone --version
  test -s /usr/share/man/man1/pedzone.1.gz
  test -s /usr/share/bash-completion/completions/pedzone
  test -s /usr/share/zsh/site-functions/_pedzone
  test -s /usr/share/pedzone/zones.xsd
  test -s /usr/include/pedzone/crowd/crowd.hpp
  python3 -c "import pedzone; zone = pedzone.Zone.from_polygons([(0, 0), (9, 0), (9, 9), (0, 9)])
crowd = pedzone.Crowd(zone); crowd.add((1, 1), (8, 8)); crowd.step(1.0); assert crowd.x[0] > 1"
  pedzone study run /example.study.xml --out /results --quiet
  grep -q "What the study found" /results/report.html
  pedzone study status /results'
