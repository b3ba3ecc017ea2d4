# Two stages: the first builds, the second holds only the program and the libraries that it loads.
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
RUN install -D --strip build/release/tia /image/tia \
 && install -D -m 644 LICENSE /image/LICENSE \
 && for library in $(ldd build/release/tia | grep -o '/[^ ]*'); do \
      install -D "$library" "/image$library"; \
    done

FROM scratch
LABEL org.opencontainers.image.title="Tia" \
      org.opencontainers.image.description="A ray-tracing render service" \
      org.opencontainers.image.authors="The Tia authors" \
      org.opencontainers.image.licenses="MIT"
COPY --from=build /image /
ENV TIA_HOST=0.0.0.0
EXPOSE 8080
USER 65532:65532
STOPSIGNAL SIGTERM
HEALTHCHECK --interval=10s --timeout=3s --start-period=5s CMD ["/tia", "--healthcheck"]
ENTRYPOINT ["/tia"]
CMD ["serve"]
