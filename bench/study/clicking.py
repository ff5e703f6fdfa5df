"""A mesh of the study with its exact labels, as the library sees it, and what clicks on it give."""
import numpy as np

import meshes
from library import Library, Scan
from pieces import library_path
from scoring import Truth


class Arch:
    def __init__(self, study, mesh, threads=1):
        self.study, self.mesh = study, mesh
        self.v, self.f, self.reference = meshes.read(mesh)
        self.truth = Truth(self.v, self.f, self.reference)
        self.scan = Scan(Library(library_path(study), threads), mesh.path)

    def size(self):
        """What a table says of the mesh: elements, teeth, groups found, mean edge length (mm)."""
        ends = self.v[self.truth.edge]
        return {**meshes.size_of(self.mesh), "teeth": len(set(self.reference[self.reference > 0])),
                "groups": len(self.scan.groups()), "mean_edge": float(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).mean())}

    def clicks(self, how, seed):
        """Positions, and the teeth that they are on."""
        return meshes.clicks(self.study, self.v, self.f, self.reference, how, seed)

    def top_of(self, tooth):
        """A click on a tooth (FDI): the face nearest the middle of its top."""
        crown, up = self.v[self.f[self.reference == tooth]].mean(1), self.scan.occlusal()
        top = crown[crown @ up > np.percentile(crown @ up, 60)]
        return top[np.linalg.norm(np.cross(top - crown.mean(0), up), axis=1).argmin()]

    def clicked(self, seeds, how="pairs", preset="default", keep=None, **settings):
        """Figures a tooth for the clicks of each seed, each on a preparation of its own. `keep`: a file for the first seed's clicks,
        and the labels after each, for who draws them."""
        out = {}
        for seed in seeds:
            segmentation = self.scan.prepare(preset, **settings)
            positions, teeth = self.clicks(how, seed)
            failed, after = [], []
            for position in positions:
                failed += segmentation.click_all([position])
                if keep and seed == seeds[0]:
                    after.append(segmentation.labels().astype(np.uint8))
            if after:
                np.savez_compressed(keep, clicks=positions, labels=after)
            out[str(seed)] = {"clicks": len(teeth), "failed": failed, "teeth": self.truth.figures(segmentation.labels())}
        return out
