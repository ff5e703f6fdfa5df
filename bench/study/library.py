"""The library through its C functions (include/toothseg.h), as far as the study needs them. NumPy arrays in and out."""
import ctypes as c

import numpy as np

NONE = 0xffffffff
PRESETS = {"default": 0, "paper": 1}
WEIGHTS = {"cotangent": 2, "Meng": 4, "Eq. 8": 1, "ours": 0}  # ts_weights


class Failure(Exception):
    """A status other than TS_OK, with the library's message."""

    def __init__(self, status, message):
        super().__init__(status, message)  # as given, for the way from one process to another
        self.status = status

    def __str__(self):
        return "%s: %s" % self.args


def struct(name, fields):
    return type(name, (c.Structure,), {"_fields_": [(n, t) for t, names in fields for n in names.split()]})


u32, f64 = c.c_uint32, c.c_double
ContextOptions = struct("ContextOptions", [(u32, "struct_size threads"), (c.c_void_p, "alloc free alloc_user log log_user")])
FeaturePoint = struct("FeaturePoint", [(u32, "id group vertex by_hand"), (f64 * 3, "position"), (f64, "convexity")])
FeatureGroup = struct("FeatureGroup", [(u32, "id points previous next"), (f64 * 3, "centre"),
                                       (f64, "arch_from arch_to confidence")])
SegmentOptions = struct("SegmentOptions", [
    (u32, "struct_size preset weights background cut_rule contours histogram_bins points_per_group"),
    (f64, "alpha beta gamma theta c0 normal_radius seed_radius gingiva_distance area_min area_max hole_area refine_band "
          "smooth_radius click_reach click_concavity"), (u32, "reject_outliers"), (c.c_uint64, "memory_limit")])
ClickInfo = struct("ClickInfo", [
    (u32, "struct_size target neighbour"), (f64 * 3, "position"),
    (f64, "target_distance neighbour_distance v_med target_iso neighbour_iso pick field cut label total")])
ContourInfo = struct("ContourInfo", [(f64, "iso gradient concavity length"), (u32, "points polylines chosen")])
EdgePoint = struct("EdgePoint", [(u32, "a b"), (f64, "t"), (f64 * 3, "position")])
ToothInfo = struct("ToothInfo", [(u32, "struct_size id label click faces vertices loops seeds"),
                                 (f64, "area iso gradient confidence"), (u32, "warnings")])
CutInfo = struct("CutInfo", [(u32, "struct_size points closed"), (f64, "length iso gradient concavity")])
PrepareTimes = struct("PrepareTimes", [(u32, "struct_size reserved"), (f64, "intake features weights factorise")])


class Library:
    """libtoothseg.so. What it hands out is given back when Python drops it."""

    def __init__(self, path, threads=1):
        self.lib = c.CDLL(path)
        for name in ("ts_last_error_message", "ts_status_name", "ts_version"):
            getattr(self.lib, name).restype = c.c_char_p
        options = ContextOptions()
        self.call("ts_context_options_init", c.byref(options), c.sizeof(options))
        options.threads = threads
        self.context = self.make("context", "ts_context_create", c.byref(options))

    def call(self, name, *arguments):
        status = getattr(self.lib, name)(*arguments)
        if status:
            raise Failure(self.lib.ts_status_name(status).decode(), self.lib.ts_last_error_message().decode())

    def make(self, kind, function, *arguments):
        out = c.c_void_p()
        self.call(function, *arguments, c.byref(out))
        return Handle(self, kind, out)

    def fill(self, function, handle, dtype, *arguments, rest=()):
        """An array from a getter: asked for its length first. `dtype` a NumPy type, or a structure."""
        count = u32()
        self.call(function, handle, *arguments, None, 0, c.byref(count), *rest)
        if isinstance(dtype, type) and issubclass(dtype, c.Structure):
            out = (dtype * count.value)()
            self.call(function, handle, *arguments, out, count, c.byref(count), *rest)
            return list(out)
        kind, width = dtype
        out = np.empty((count.value, width) if width > 1 else count.value, kind)
        self.call(function, handle, *arguments, out.ctypes.data_as(c.c_void_p), count, c.byref(count), *rest)
        return out

    @property
    def version(self):
        return self.lib.ts_version().decode()


class Handle:
    def __init__(self, library, kind, pointer):
        self.library, self.kind, self._as_parameter_ = library, kind, pointer

    def __del__(self):
        getattr(self.library.lib, "ts_%s_destroy" % self.kind)(self._as_parameter_)


class Scan:
    """A model and its features."""

    def __init__(self, library, path):
        self.library = library
        self.model = library.make("model", "ts_model_load", library.context, path.encode(), None, None)
        self.features = library.make("features", "ts_detect_features", self.model, None, None)

    def positions(self):
        return self.library.fill("ts_model_get_positions", self.model, (np.float64, 3))

    def triangles(self):
        return self.library.fill("ts_model_get_triangles", self.model, (np.uint32, 3)).astype(np.int64)

    def sources(self):
        """The face of the file for each face of the model."""
        return self.library.fill("ts_model_get_face_sources", self.model, (np.uint32, 1)).astype(np.int64)

    def occlusal(self):
        out = (f64 * 3)()
        self.library.call("ts_features_get_occlusal", self.features, out)
        return np.array(out)

    def points(self, features=None):
        return self.library.fill("ts_features_get_points", features or self.features, FeaturePoint)

    def groups(self):
        return self.library.fill("ts_features_get_groups", self.features, FeatureGroup)

    def clone_features(self):
        return self.library.make("features", "ts_features_clone", self.features)

    def prepare(self, preset="default", features=None, **settings):
        return Segmentation(self, features or self.features, preset, settings)


class Segmentation:
    def __init__(self, scan, features, preset, settings):
        self.scan, self.library = scan, scan.library
        options = SegmentOptions()
        self.library.call("ts_segment_options_init", c.byref(options), c.sizeof(options), PRESETS[preset])
        for name, value in settings.items():
            setattr(options, name, value)
        self.handle = self.library.make("segmentation", "ts_segmentation_create", features, c.byref(options), None)

    def click(self, position):
        click = u32()
        self.library.call("ts_segment_click", self.handle, (f64 * 3)(*position), None, c.byref(click))
        return click.value

    def click_all(self, positions):
        """How many of the clicks failed, with the reasons."""
        failed = []
        for p in positions:
            try:
                self.click(p)
            except Failure as e:
                failed.append(e.status)
        return failed

    def proposed(self):
        return self.library.fill("ts_propose_clicks", self.handle, (np.float64, 3))

    def labels(self):
        return self.library.fill("ts_get_labels", self.handle, (np.uint32, 1)).astype(np.int64)

    def info(self, click):
        out = ClickInfo(struct_size=c.sizeof(ClickInfo))
        self.library.call("ts_get_click", self.handle, u32(click), c.byref(out))
        return out

    def field(self, click):
        return self.library.fill("ts_get_field", self.handle, (np.float64, 1), u32(click))

    def histogram(self, click):
        return self.library.fill("ts_get_histogram", self.handle, (np.uint32, 1), u32(click))

    def contours(self, click):
        return self.library.fill("ts_get_contours", self.handle, ContourInfo, u32(click))

    def contour_lines(self, click, contour):
        """Polylines of one contour, closed ones with their first point again at the end."""
        arguments = (self.handle, u32(click), u32(contour))
        lines = self.contours_of(click)[contour].polylines
        starts, closed = (u32 * max(1, lines))(), (c.c_uint8 * max(1, lines))()
        points = self.library.fill("ts_get_contour_points", self.handle, EdgePoint, *arguments[1:], rest=(starts, closed))
        xyz = np.array([tuple(p.position) for p in points]).reshape(-1, 3)
        ends = list(starts)[1:lines] + [len(xyz)]
        cut = [xyz[a:b] for a, b in zip(starts, ends)] if lines else []
        return [np.vstack([l, l[:1]]) if k else l for l, k in zip(cut, closed)]

    def contours_of(self, click):
        if getattr(self, "_contours", (None,))[0] != click:
            self._contours = (click, self.contours(click))
        return self._contours[1]

    def teeth(self):
        return self.library.fill("ts_get_teeth", self.handle, (np.uint32, 1))

    def tooth(self, tooth):
        out = ToothInfo(struct_size=c.sizeof(ToothInfo))
        self.library.call("ts_get_tooth", self.handle, u32(tooth), c.byref(out))
        return out

    def seeds(self, tooth):
        return self.library.fill("ts_get_tooth_seeds", self.handle, (np.uint32, 1), u32(tooth))

    def cuts(self, tooth):
        """The closed polylines of a tooth's cut."""
        out = []
        for loop in range(self.tooth(tooth).loops):
            count = u32()
            self.library.call("ts_get_cut", self.handle, u32(tooth), u32(loop), None, None, 0, c.byref(count))
            points = (EdgePoint * count.value)()
            self.library.call("ts_get_cut", self.handle, u32(tooth), u32(loop), None, points, count, c.byref(count))
            xyz = np.array([tuple(p.position) for p in points]).reshape(-1, 3)
            out.append(np.vstack([xyz, xyz[:1]]))
        return out

    def all(self):
        self.library.call("ts_segment_all", self.handle, None)

    def correct(self, what, tooth, position):
        """`what`: include or exclude."""
        self.library.call("ts_tooth_" + what, self.handle, u32(tooth), (f64 * 3)(*position), None)

    def move_point(self, tooth, start, to):
        self.library.call("ts_tooth_move_point", self.handle, u32(tooth), (f64 * 3)(*start), (f64 * 3)(*to), None)

    def draw(self, tooth, points):
        points = np.ascontiguousarray(points, np.float64)
        self.library.call("ts_cut_draw", self.handle, u32(tooth), points.ctypes.data_as(c.c_void_p), u32(len(points)), None)

    def undo(self):
        self.library.call("ts_undo", self.handle)

    def tooth_of_label(self, label):
        return next(int(t) for t in self.teeth() if self.tooth(int(t)).label == label)

    def times(self):
        out = PrepareTimes(struct_size=c.sizeof(PrepareTimes))
        self.library.call("ts_get_prepare_times", self.handle, c.byref(out))
        return {n: getattr(out, n) for n in ("intake", "features", "weights", "factorise")}
