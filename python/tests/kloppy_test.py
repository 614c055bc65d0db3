"""A match of cls in kloppy itself: frames, periods, orientation, other coordinate systems."""
import csv
import gzip
import os
import pathlib
import subprocess
import tempfile
import unittest

CLS = os.environ.get("CLS_BINARY", "cls")

try:
    import kloppy.domain as domain
except ImportError:
    domain = None


@unittest.skipIf(domain is None, "no kloppy: pip install kloppy")
class Kloppy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.folder.name)
        subprocess.run([CLS, "match", "mock", "mock:simple", "--half-time", "30", "--seed", "3",
                        "--dir", folder / "match", "--quiet"], check=True,
                       stdout=subprocess.DEVNULL)
        cls.table = folder / "match.tracking.csv"
        subprocess.run([CLS, "convert", folder / "match", cls.table], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with open(cls.table, encoding="utf-8", newline="") as file:
            cls.rows = list(csv.DictReader(file))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def load(self, **more):
        from cls_gym.adapters.kloppy import load_tracking
        return load_tracking(self.table, **more)

    def test_frames_are_those_of_the_table(self):
        dataset = self.load()
        self.assertEqual(dataset.metadata.frame_rate, 10)
        self.assertEqual([team.name for team in dataset.metadata.teams],
                         [self.rows[50]["l_name"], self.rows[50]["r_name"]])
        by_number = {int(row["#"]): row for row in self.rows}
        self.assertGreater(len(dataset), 550)
        for frame in dataset.records[::37]:
            row = by_number[frame.frame_id]
            self.assertEqual(frame.ball_coordinates.x, float(row["b_x"]))
            self.assertEqual(len(frame.players_data), 22)
            self.assertEqual(frame.ball_state == domain.BallState.ALIVE,
                             row["playmode"] == "play_on")
            [player] = [one for one in frame.players_data if one.player_id == "right_7"]
            data = frame.players_data[player]
            self.assertEqual((data.coordinates.x, data.coordinates.y),
                             (float(row["r7_x"]), float(row["r7_y"])))
            self.assertEqual(data.other_data["stamina"], float(row["r7_stamina"]))

    def test_halves_are_periods(self):
        dataset = self.load()
        first, second = dataset.metadata.periods
        self.assertEqual((first.id, second.id), (1, 2))
        self.assertGreaterEqual(first.duration.total_seconds(), 29)
        begins = [frame for frame in dataset if frame.timestamp.total_seconds() == 0]
        self.assertEqual([frame.period.id for frame in begins], [1, 2])
        self.assertLess(begins[0].other_data["cycle"], 3)
        self.assertGreaterEqual(begins[1].other_data["cycle"], 300)

    def test_left_team_attacks_to_the_right_in_both_halves(self):
        dataset = self.load()
        home = dataset.metadata.teams[0]
        self.assertEqual(dataset.metadata.orientation, domain.Orientation.STATIC_HOME_AWAY)
        for period in dataset.metadata.periods:
            keeper = [frame.players_data[home.players[0]].coordinates.x for frame in dataset
                      if frame.period is period]
            self.assertLess(sum(keeper) / len(keeper), -40)

    def test_transforms_to_other_coordinates(self):
        dataset = self.load(limit=40)
        self.assertEqual(len(dataset), 40)
        other = dataset.transform(to_coordinate_system="kloppy")
        for frame, moved in zip(dataset, other):
            self.assertAlmostEqual(moved.ball_coordinates.x,
                                   (frame.ball_coordinates.x + 52.5) / 105.0, 6)
            self.assertAlmostEqual(moved.ball_coordinates.y,
                                   (frame.ball_coordinates.y + 34.0) / 68.0, 6)
        turned = dataset.transform(to_orientation="STATIC_AWAY_HOME")
        self.assertAlmostEqual(turned[0].ball_coordinates.x, -dataset[0].ball_coordinates.x, 6)

    def test_becomes_a_table_of_pandas(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("no pandas: pip install pandas")
        frame = self.load(limit=30).to_df(engine="pandas")
        self.assertEqual(len(frame), 30)
        self.assertIn("left_3_x", frame.columns)
        self.assertFalse(frame[["ball_x", "right_11_y"]].isna().any().any())

    def test_compressed_files_and_faults(self):
        from cls_gym import ConfigError
        from cls_gym.adapters.kloppy import load_tracking
        packed = self.table.with_suffix(".csv.gz")
        packed.write_bytes(gzip.compress(self.table.read_bytes()))
        self.assertEqual(len(load_tracking(packed, limit=5)), 5)
        wrong = self.table.with_name("wrong.csv")
        wrong.write_text("a,b\n1,2\n", "utf-8")
        with self.assertRaisesRegex(ConfigError, "wrong.csv has no column '#'; write it with"):
            load_tracking(wrong)
        wrong.write_text(self.table.read_text("utf-8").split("\n")[0] + "\n", "utf-8")
        with self.assertRaisesRegex(ConfigError, "no half is played in .*wrong.csv"):
            load_tracking(wrong)


if __name__ == "__main__":
    unittest.main()
