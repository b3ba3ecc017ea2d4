# Two stages: the first builds, the second holds only what server/image.sh lays out: the program, the
# libraries that it loads, their licences and /sbom.spdx.json, the list of all that.
FROM debian:bookworm-slim AS build
WORKDIR /tia
COPY server/packages.txt server/
RUN apt-get update \
 && apt-get install -y --no-install-recommends $(awk '$1 == "build" {print $2}' server/packages.txt) \
 && rm -rf /var/lib/apt/lists/*
COPY . .
ARG TIA_ARCH=x86-64-v3
RUN cmake --preset release -DTIA_TESTS=OFF -DTIA_ARCH="$TIA_ARCH" \
 && cmake --build --preset release --target tia
RUN server/image.sh build/release /image
# Where a volume may be put for what is to be kept: it takes over the folder's owner. Root's group is
# that of any other user that a cluster may choose.
RUN install -d -m 775 /volume/data

FROM scratch
# When and of what it was made is for who makes it to say: docker build --label, see server/README.md.
LABEL org.opencontainers.image.title="Tia" \
      org.opencontainers.image.description="A ray-tracing render service" \
      org.opencontainers.image.version="0.4.2" \
      org.opencontainers.image.authors="The Tia authors" \
      org.opencontainers.image.licenses="MIT"
COPY --from=build /image /
COPY --from=build --chown=65532:0 /volume /
ENV TIA_HOST=0.0.0.0
EXPOSE 8080
USER 65532:65532
STOPSIGNAL SIGTERM
HEALTHCHECK --interval=10s --timeout=3s --start-period=5s CMD ["/tia", "--healthcheck"]
ENTRYPOINT ["/tia"]
CMD ["serve"]
