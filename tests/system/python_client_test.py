"""The Python client with a real daemon and solver. Usage: python_client_test.py CAPSTAN. Exit code 77: skipped."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy as np
except ImportError:
    print("skipped: there is no numpy (apt-get install python3-numpy)")
    sys.exit(77)

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "runner" / "python"))
import capstan  # noqa: E402

PROGRAM = sys.argv.pop()
STUDY = {
    "name": "cells",
    "base": {"shape": "biconcave", "law": "skalak", "C": 5, "V": 4, "fluid": "stokes",
             "until": {"kt": 2}, "fidelity": {"nodes": 162}, "outputs": {"history_every": 0.25, "shapes_every": 0.5}},
    "axes": {"Ca": [0.1, 0.4], "E_b": [0.015]},
}


class PythonClient(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory()
        environment = {name: value for name, value in os.environ.items() if not name.startswith("CAPSTAN_")}
        cls.daemon = subprocess.Popen(
            [PROGRAM, "serve", "--data", cls.directory.name + "/data", "--listen", "127.0.0.1:0", "--cores", "1"],
            stdout=subprocess.PIPE, text=True, env={**environment, "CAPSTAN_TOKEN": "0123456789abcdef"})
        cls.server = capstan.Server(re.search(r"http://[\d.:]+", cls.daemon.stdout.readline())[0], "0123456789abcdef")
        cls.study = cls.server.submit(STUDY).wait(seconds=0.1)

    @classmethod
    def tearDownClass(cls):
        cls.daemon.terminate()
        cls.daemon.wait()
        cls.daemon.stdout.close()
        cls.directory.cleanup()

    def test_study_is_found_by_its_name_and_by_the_beginning_of_its_id(self):
        self.assertEqual(self.server.study("cells").id, self.study.id)
        self.assertEqual(self.server.study(self.study.id[:-1]).id, self.study.id)
        with self.assertRaises(LookupError):
            self.server.study("nobody")

    def test_cases_are_one_row_a_point(self):
        cases = self.study.cases()
        rows = cases if isinstance(cases, list) else cases.reset_index().to_dict("records")
        self.assertEqual([row["Ca"] for row in rows], [0.1, 0.4])
        self.assertEqual([row["state"] for row in rows], ["done", "done"])
        self.assertIn("error.Q", rows[0])

    def test_rows_are_those_of_the_csv(self):
        csv = self.server.request(self.study.path + "/cases", {"format": "csv"}).decode()
        header = csv.split("\r\n", 1)[0].split(",")
        cases = self.study.cases()
        columns = cases[0] if isinstance(cases, list) else cases.reset_index().columns
        self.assertLessEqual(set(columns), set(header))

    def test_case_without_a_result_has_no_further_columns(self):
        study = self.server.submit({**STUDY, "name": "long", "axes": {"Ca": [0.2, 0.3]},
                                    "base": {**STUDY["base"], "until": {"kt": 1000}}})
        cases = study.cases()
        columns = cases[0] if isinstance(cases, list) else cases.columns
        self.assertIn("motion", columns)
        self.assertFalse({"error", "trust", "cost", "final", "evidence"} & set(columns), "groups of columns")
        self.server.request(study.path, method="DELETE")

    @unittest.skipIf(capstan.pandas is None, "there is no pandas")
    def test_cases_are_a_data_frame_whose_numbers_can_be_selected_and_plotted(self):
        cases = self.study.cases()
        self.assertEqual(cases.index.name, "point")
        self.assertEqual(list(cases[cases.Ca > 0.2].index), [2])
        self.assertEqual(cases["final.D_xy"].dtype, float)
        self.assertEqual(len(cases.to_csv().splitlines()), 3)

    @unittest.skipIf(capstan.xarray is None, "there is no xarray")
    def test_histories_are_a_dataset_over_point_and_time(self):
        histories = self.study.histories(every=0.5)
        self.assertEqual(dict(histories.sizes), {"point": 2, "kt": 5})
        self.assertEqual(histories.D_xy.dims, ("point", "kt"))
        of_ca = histories.swap_dims(point="Ca").D_xy.sel(Ca=0.4)
        np.testing.assert_array_equal(of_ca, self.study.case(2).history()["D_xy"][::2])
        self.assertEqual(len(histories.to_dataframe()), 10)

    def test_histories_are_on_one_grid(self):
        histories = self.study.histories(every=0.125, columns=["D_xy"])
        self.assertEqual(list(np.asarray(histories["kt"])), [0.125 * i for i in range(17)])
        self.assertEqual(list(np.asarray(histories["Ca"])), [0.1, 0.4])
        self.assertNotIn("theta", histories)
        for point, on_grid in enumerate(np.asarray(histories["D_xy"]), start=1):
            recorded = self.study.case(point).history()["D_xy"]
            np.testing.assert_array_equal(on_grid[::2], recorded)
            np.testing.assert_allclose(on_grid[1::2], (recorded[:-1] + recorded[1:]) / 2, rtol=1e-12)

    def test_grid_is_that_of_the_records(self):
        histories = self.study.histories()
        self.assertEqual(list(np.asarray(histories["kt"])), [0.25 * i for i in range(9)])
        self.assertTrue(np.isfinite(np.asarray(histories["theta"])).all())

    def test_shapes_have_the_deformation_of_the_history(self):
        case = self.study.case(2)
        shapes, history = case.shapes(), case.history()
        self.assertEqual(list(shapes["kt"]), [0, 0.5, 1, 1.5, 2])
        corners = shapes["positions"].astype(float)[:, shapes["triangles"]]
        volumes = np.einsum("tfi,tfi->t", corners[:, :, 0], np.cross(corners[:, :, 1], corners[:, :, 2])) / 6
        np.testing.assert_allclose(volumes, history["volume"][::2], rtol=1e-5)
        self.assertGreater(shapes["stretches"].max(), 1)

    def test_refusal_names_each_issue(self):
        with self.assertRaises(capstan.Refused) as refused:
            self.server.submit({"name": "a b", "base": {}})
        self.assertEqual(refused.exception.status, 422)
        self.assertIn("/name", [pointer for pointer, _ in refused.exception.issues])

    def test_wrong_token_is_refused(self):
        with self.assertRaises(capstan.Refused) as refused:
            capstan.Server(self.server.url, "fedcba9876543210").studies()
        self.assertEqual(refused.exception.status, 401)


if __name__ == "__main__":
    unittest.main()
