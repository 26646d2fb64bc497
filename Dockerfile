# The program, the Python package and the cases on Debian 12:
#
#   docker build -t lumbricus .          # or: buildah build --format docker -t lumbricus .
#   docker run --rm -v "$PWD:/home/worm" lumbricus \
#     mpirun -np 2 lumbricus /opt/lumbricus/parameters/antagonism/case.prm --output results
#
# What is committed is built, by packaging/debian; JOBS compilers at a time.
FROM debian:bookworm-slim AS built
ARG JOBS=2
WORKDIR /lumbricus
COPY packaging packaging
RUN apt-get update -q \
 && apt-get install -y -q --no-install-recommends ca-certificates dpkg-dev git \
 && apt-get build-dep -y -q --no-install-recommends ./packaging
COPY . .
RUN git config --global --add safe.directory /lumbricus \
 && JOBS=$JOBS scripts/release.sh /packages tarball deb

FROM debian:bookworm-slim
COPY --from=built /packages /packages
# As python_packages in scripts/environment.sh; pyvista draws with EGL.
RUN apt-get update -q \
 && apt-get install -y -q --no-install-recommends ca-certificates libopenblas0-serial \
      python3 python3-venv libegl1 libgl1-mesa-dri /packages/lumbricus_*.deb \
 && mkdir /opt/lumbricus \
 && tar -xzf /packages/lumbricus-*.tar.gz -C /opt/lumbricus --strip-components=1 \
 && python3 -m venv /opt/python \
 && /opt/python/bin/pip install -q --no-cache-dir "/opt/lumbricus/python[fields]" \
 && rm -rf /packages /var/lib/apt/lists/* \
 && useradd --create-home worm
# A rank a core; Open MPI leaves its ranks where the system puts them.
ENV PATH=/opt/python/bin:$PATH OMP_NUM_THREADS=1 OMPI_MCA_hwloc_base_binding_policy=none
USER worm
WORKDIR /home/worm
CMD ["lumbricus", "--help"]
