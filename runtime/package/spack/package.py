# The library and the headers, which take a C compiler alone: a copy of this file is packages/footpoint/package.py of a
# Spack repository.  It looks for the archive that `make dist` makes in the folder where spack is called.  That archive
# holds this file, so its checksum has to be added to the copy: `spack checksum`, or `spack install --no-checksum`.
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
