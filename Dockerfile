# Images of cps; docs/containers.md says how to use them.
#   docker build --target render -t cps .    cps: all that a render node needs
#   docker build -t cps-train .              and cps-train
FROM debian:12 AS build
RUN apt-get update && apt-get install -y --no-install-recommends git ca-certificates
COPY . /src
WORKDIR /src
RUN ./dev package

FROM debian:12-slim AS render
COPY --from=build /src/build/package/cps_*.deb /packages/
RUN apt-get update && apt-get install -y --no-install-recommends /packages/cps_*.deb && \
    rm -rf /packages /var/lib/apt/lists/*
RUN useradd --create-home --uid 1000 cps && install -d -o cps -g cps /data
USER cps
WORKDIR /data
CMD ["cps", "help"]

FROM render AS train
USER root
COPY --from=build /src/build/package/cps-train_*.deb /packages/
RUN apt-get update && apt-get install -y --no-install-recommends /packages/cps-train_*.deb && \
    rm -rf /packages /var/lib/apt/lists/*
USER cps
