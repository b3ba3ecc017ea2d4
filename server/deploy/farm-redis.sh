#!/bin/sh
# The Redis of a farm: synced before it answers; what it has no room for it refuses; one user, tia,
# for Tia's keys and channels alone, by the password in FARM_PASSWORD_FILE.
set -eu
umask 077
users=${FARM_ACL_FILE:-/tmp/users.acl}
printf 'user default off\nuser tia on #%s ~{tia}:* &{tia}:* +@all -@admin -@dangerous\n' \
  "$(tr -d '\n' < "${FARM_PASSWORD_FILE:-/run/secrets/farm}" | sha256sum | cut -c1-64)" > "$users"
exec redis-server --aclfile "$users" --appendonly yes --appendfsync always --save '' \
  --maxmemory "${FARM_MEMORY:-2gb}" --maxmemory-policy noeviction "$@"
