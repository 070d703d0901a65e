#!/bin/sh
# Rebuilds the networks of these tests with netconvert (SUMO 1.15). The town is built twice: with
# walking areas and crossings, and without, as netconvert does when it is not asked for them.
set -eu
cd "$(dirname "$0")"
convert() {
    output=$1
    shift
    netconvert --node-files town.nod.xml --edge-files town.edg.xml --ignore-errors.edge-type \
        --offset.disable-normalization --no-turnarounds --no-warnings --output-file "$output" "$@"
    # The header names the date and folders.
    sed -i '/^<!-- generated on/,/^-->/d' "$output"
}
convert town.net.xml --connection-files town.con.xml --walkingareas
convert bare.net.xml
