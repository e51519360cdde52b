"""Client of a Capstan daemon: studies, cases, histories and shapes as arrays and tables.

    import capstan
    study = capstan.study("fig17")            # by its id, the beginning of its id, or its name
    table = study.cases()                     # one row a point: a DataFrame, or a list of dictionaries
    histories = study.histories()             # all on one time grid: an xarray.Dataset, or a dictionary of arrays
    shapes = study.case(1).shapes()           # positions, velocities, forces, stretches, triangles

Needs Python 3.9 and numpy. pandas and xarray are used where they are installed. The daemon's address is that of the
commands: the environment's CAPSTAN_SERVER, or http://127.0.0.1:8017; its token that of CAPSTAN_TOKEN or
CAPSTAN_TOKEN_FILE.
"""

import json
import os
import pathlib
import time
import urllib.error
import urllib.parse
import urllib.request

import numpy as np

try:
    import pandas
except ImportError:
    pandas = None
try:
    import xarray
except ImportError:
    xarray = None

GROUPS = ("evidence", "final", "cost", "trust", "error")  # of columns; null before there is a result
DTYPES = {"F64": "<f8", "F32": "<f4", "U32": "<u4"}


class Refused(Exception):
    """The daemon refused a request. `issues` holds (pointer, detail) of each thing that is wrong."""

    def __init__(self, status, problem):
        self.status = status
        self.issues = [(issue["pointer"], issue["detail"]) for issue in problem.get("errors", [])]
        details = [f"{pointer}: {detail}" for pointer, detail in self.issues]
        super().__init__("; ".join([problem.get("detail", f"status {status}"), *details]))


class Server:
    """A daemon at a URL."""

    def __init__(self, url=None, token=None):
        self.url = (url or os.environ.get("CAPSTAN_SERVER", "http://127.0.0.1:8017")).rstrip("/")
        self.token = token or _token_of_environment()

    def request(self, path, query=(), body=None, method=None):
        """The bytes of the answer."""
        address = self.url + path + ("?" + urllib.parse.urlencode(query) if query else "")
        headers = {"Accept": "application/json"}
        if self.token:
            headers["Authorization"] = f"Bearer {self.token}"
        if body is not None:
            headers["Content-Type"] = "application/json"
        request = urllib.request.Request(address, data=body, headers=headers, method=method)
        try:
            with urllib.request.urlopen(request) as answer:
                return answer.read()
        except urllib.error.HTTPError as error:
            raise Refused(error.code, _json_or_nothing(error.read())) from None
        except urllib.error.URLError as error:
            raise ConnectionError(f"no server answers at {self.url} ({error.reason}); start one with: capstan serve") from None

    def get(self, path, query=()):
        return json.loads(self.request(path, query))

    def post(self, path, document=None):
        body = b"" if document is None else json.dumps(document).encode()
        return json.loads(self.request(path, body=body or None, method="POST"))

    def pages(self, path, query=()):
        """The pages of a list."""
        query = dict(query)
        while True:
            page = self.get(path, query)
            yield page
            if page["next"] is None:
                return
            query["after"] = page["next"]

    def items(self, path, key):
        """The items of a list, from all its pages."""
        for page in self.pages(path):
            yield from page[key]

    def studies(self):
        """All studies, the newest first."""
        return [Study(self, item["id"]) for item in self.items("/v1/studies", "studies")]

    def study(self, word):
        """The study with this id, this name, or an id that begins with it."""
        return Study(self, self._one_id(word, "studies"))

    def case(self, word):
        """The case with this id, or an id that begins with it."""
        return Case(self, self._one_id(word, "cases"))

    def submit(self, document):
        """Submits a study: a dictionary, or the path of a file."""
        if not isinstance(document, dict):
            document = json.loads(pathlib.Path(document).read_text())
        return Study(self, self.post("/v1/studies", document)["id"])

    def plan(self, document):
        """What a study or a case will model and cost; nothing is stored."""
        return self.post("/v1/plan", document)

    def _one_id(self, word, kind):
        found = self.get("/v1/ids/" + urllib.parse.quote(word, safe=""))[kind]
        if len(found) != 1:
            raise LookupError(f"{word!r} is " + (f"one of several {kind}: {', '.join(found)}" if found else f"none of the {kind}"))
        return found[0]


class Study:
    def __init__(self, server, id):
        self.server = server
        self.id = id
        self.path = "/v1/studies/" + urllib.parse.quote(id, safe="")

    def __repr__(self):
        return f"<capstan study {self.id}>"

    def show(self):
        """Axes, state, progress, number of cases in each state."""
        return self.server.get(self.path)

    def wait(self, seconds=2.0, report=None):
        """Waits until all cases have ended. Calls `report` with the study each time it has asked."""
        while True:
            shown = self.show()
            if report:
                report(shown)
            if shown["state"] in ("done", "cancelled"):
                return self
            time.sleep(seconds)

    def points(self):
        """What is known of each point, as nested dictionaries (schema/http.md)."""
        return list(self.server.items(self.path + "/cases", "cases"))

    def cases(self):
        """One row for each point: a pandas.DataFrame, else a list of dictionaries. Columns as in schema/results.md."""
        rows = [_flat(point) for point in self.points()]
        if pandas is None:
            return rows
        return pandas.DataFrame(rows).set_index("point")

    def case(self, point):
        """The case of a point, which are numbered from 1."""
        for item in self.points():
            if item["point"] == point:
                return Case(self.server, item["id"])
        raise LookupError(f"{self.id} has no point {point}")

    def histories(self, every=None, columns=None):
        """The histories of all points on one time grid, linear between two records, NaN after the end of a run.

        every    distance of the times; by default that of the records
        columns  names of observables; by default all
        Returns an xarray.Dataset over `point` and `kt`, with the values of the axes as coordinates; without xarray a
        dictionary of arrays #points x #kt, with `kt`, `point` and the axes.
        """
        query = {"every": every, "columns": columns and ",".join(columns)}
        pages = list(self.server.pages(self.path + "/histories", {key: value for key, value in query.items() if value}))
        points = [point for page in pages for point in page["points"]]
        kt = max((np.array(page["kt"]) for page in pages), key=len)  # a run may go on from page to page
        data = {name: np.array([_padded(point["history"][name], len(kt)) for point in points])
                for name in (points[0]["history"] if points else {})}
        coordinates = {"point": np.array([point["point"] for point in points])}
        for axis in self.show()["axes"]:
            name = axis["parameter"]
            coordinates[name] = np.array([_word(point["asked"][name]) for point in points])
        if xarray is None:
            return {"kt": kt, **coordinates, **data}
        return xarray.Dataset(
            {name: (("point", "kt"), values) for name, values in data.items()},
            coords={"kt": kt, "point": coordinates.pop("point"),
                    **{name: ("point", values) for name, values in coordinates.items()}})

    def phase_diagram(self, **section):
        """The motion over two axes. phase_diagram(x="Ca", y="V", at=["E_b=0.015"])"""
        return self.server.get(self.path + "/phase-diagram", [
            (name, value) for name, given in section.items() for value in ([given] if isinstance(given, str) else given)])

    def boundary(self):
        """Where the motion changes, of a study that seeks it (schema/http.md); Refused for other studies."""
        return self.server.get(self.path + "/boundary")


class Case:
    def __init__(self, server, id):
        self.server = server
        self.id = id
        self.path = "/v1/cases/" + urllib.parse.quote(id, safe="")

    def __repr__(self):
        return f"<capstan case {self.id}>"

    def show(self):
        """Parameters, motion, evidence, errors, attempts."""
        return self.server.get(self.path)

    def history(self):
        """One array for each observable, NaN where there is no number."""
        columns = self.server.get(self.path + "/history")
        return {name: _numbers(values) for name, values in columns.items()}

    def shapes(self):
        """The recorded shapes as arrays (schema/shapes.md), with `kt`; LookupError if there are none."""
        if not self.server.get(self.path + "/shapes")["kt"]:
            raise LookupError(f"case {self.id} has recorded no shapes (outputs.shapes_every)")
        parts, total, first = [], 1, 0
        while first < total:
            notes, arrays = _read_tensors(self.server.request(self.path + "/shapes", {"format": "binary", "first": first}))
            parts.append(arrays)
            total, first = int(notes["total"]), first + len(arrays["kt"])
        triangles = parts[0].pop("triangles")
        return {**{name: np.concatenate([part[name] for part in parts]) for name in parts[0]}, "triangles": triangles}


def study(word):
    return Server().study(word)


def case(word):
    return Server().case(word)


def studies():
    return Server().studies()


def submit(document):
    return Server().submit(document)


def plan(document):
    return Server().plan(document)


def _token_of_environment():
    file = os.environ.get("CAPSTAN_TOKEN_FILE")
    return pathlib.Path(file).read_text().strip() if file else os.environ.get("CAPSTAN_TOKEN")


def _json_or_nothing(text):
    try:
        return json.loads(text)
    except ValueError:
        return {}


def _word(value):
    """A value of an axis: a number, a word, or a fidelity as JSON."""
    return json.dumps(value) if isinstance(value, dict) else value


def _flat(value, prefix=""):
    """{"error": {"Q": 0.01}} as {"error.Q": 0.01}; parameters have no prefix, as in the CSV."""
    row = {}
    for key, item in value.items():
        if prefix == "asked.":
            row[prefix + key] = _word(item)
        elif isinstance(item, dict):
            row.update(_flat(item, "" if not prefix and key == "parameters" else f"{prefix}{key}."))
        elif item is not None or key not in GROUPS:
            row[prefix + key] = item
    return row


def _numbers(values):
    """An array with NaN where there is no number."""
    return np.array([np.nan if value is None else value for value in values], dtype=float)


def _padded(values, size):
    return np.concatenate([_numbers(values), np.full(size - len(values), np.nan)])


def _read_tensors(data):
    size = int.from_bytes(data[:8], "little")
    header = json.loads(data[8:8 + size])
    notes = header.pop("__metadata__")
    arrays = {}
    for name, entry in header.items():
        begin, end = entry["data_offsets"]
        numbers = np.frombuffer(data[8 + size + begin:8 + size + end], dtype=DTYPES[entry["dtype"]])
        arrays[name] = numbers.reshape(entry["shape"])
    return notes, arrays
