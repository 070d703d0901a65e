#!/bin/bash
# Installs the packages of Debian 12 or 13 that pedzone needs and that are missing; nothing when none is.
# tools/run.sh and tools/test.sh call it.
set -euo pipefail

if [[ "${1:-}" == "--help" || "${1:-}" == "-h" ]]; then
  echo "usage: tools/install.sh [--long]   installs what is missing (Debian 12 or 13, root or sudo)"
  echo "  --long    also what only the long tests need"
  exit 0
fi

packages=(
  cmake ninja-build g++ ccache      # build
  sumo sumo-tools                   # simulation, network tools, libsumo; the schemas SUMO checks with
  libeigen3-dev                     # vectors
  libfmt-dev                        # text
  libcli11-dev                      # command line
  libpugixml-dev libexpat1-dev zlib1g-dev  # SUMO's XML, held and streamed, plain and compressed
  nlohmann-json3-dev                # summaries
  libproj-dev                       # longitude and latitude of places in a network
  libsqlitecpp-dev                  # trajectories as JuPedSim's database
  libssl-dev                        # checksums of what a study ran on
  libkainjow-mustache-dev           # the template of a study's report
  libtbb-dev                        # threads
  pybind11-dev python3-dev          # import pedzone
  libboost-dev                      # distributions; overlay of polygons; second opinion on areas
  libgtest-dev libgmock-dev libbenchmark-dev librapidcheck-dev  # tests and benchmarks
  python3 python3-shapely python3-numpy python3-pyproj python3-jsonschema  # independent checks
  python3-matplotlib                # SUMO's plot_net_dump.py reads our edge data in a test
  libxml2-utils                     # the second opinion on the schema of study files
  zsh groff-base                    # tests of completion and of the manual page
  librsvg2-bin                      # the picture as PNG
  chromium chromium-driver          # tests of pages; frames of videos
  ffmpeg                            # tests of videos
  poppler-utils                     # tests of pages on paper
  xvfb xauth netpbm                 # tests of sumo-gui, and their pictures
  slurmctld slurmd slurm-client munge  # tests of studies on a cluster, which they start themselves
)
# Fetches the libraries that draw in a study's report; any npm will do.
command -v npm >/dev/null || packages+=(nodejs npm)

# Make roots of Debian, in which the long tests build, test and install pedzone.
[[ "${1:-}" != "--long" ]] || packages+=(mmdebstrap lintian)

missing=()
installed=$'\n'$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null || true)$'\n'
for package in "${packages[@]}"; do
  [[ "$installed" == *$'\n'"installed $package"$'\n'* ]] || missing+=("$package")
done
((${#missing[@]})) || exit 0

echo "Installing: ${missing[*]}"
as_root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null || {
    echo "Error: needs root or sudo to install: ${missing[*]}" >&2
    exit 1
  }
  as_root=(sudo)
fi
as_root+=(env DEBIAN_FRONTEND=noninteractive)
"${as_root[@]}" apt-get update -q </dev/null
"${as_root[@]}" apt-get install -q -y --no-install-recommends "${missing[@]}" </dev/null
