# The library and the headers, which need only a C compiler. Copy this file to packages/footpoint/package.py of a Spack
# repository. It expects the archive of `make dist` in the folder from which spack is called. The archive contains this
# file, so add its checksum to the copy with `spack checksum`, or use `spack install --no-checksum`.
import os

from spack.package import *


class Footpoint(MakefilePackage):
    """Foot points of slave nodes on finite element faces, without iteration, for contact codes."""

    manual_download = True
    license("MIT")

    version("0.3.0")

    variant("openmp", default=False, description="Threads share the batches")

    depends_on("c", type="build")

    def url_for_version(self, version):
        return f"file://{os.getcwd()}/footpoint-{version}.tar.gz"

    @property
    def build_targets(self):
        return ["runtime"] + (["OPENMP=1"] if self.spec.satisfies("+openmp") else [])

    @property
    def install_targets(self):
        return ["install-runtime", f"PREFIX={self.prefix}"] + self.build_targets[1:]
