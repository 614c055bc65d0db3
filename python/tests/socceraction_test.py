"""The SPADL table of `cls stats` in socceraction itself: its schema, and features of VAEP."""
import io
import os
import pathlib
import subprocess
import tempfile
import unittest
import warnings

CLS = os.environ.get("CLS_BINARY", "cls")
warnings.filterwarnings("ignore")

try:
    import pandas
    import socceraction.spadl as spadl
    import socceraction.vaep.features as features
    import socceraction.vaep.labels as labels
except ImportError:
    spadl = None


@unittest.skipIf(spadl is None, "no socceraction: pip install socceraction")
class Socceraction(unittest.TestCase):
    def test_computes_features_and_labels_of_vaep(self):
        with tempfile.TemporaryDirectory() as folder:
            match = pathlib.Path(folder) / "match"
            subprocess.run([CLS, "match", "mock", "mock:simple", "--cycles", "1200", "--seed", "3",
                            "--dir", match, "--quiet"], check=True, stdout=subprocess.DEVNULL)
            text = subprocess.run([CLS, "stats", match, "--format", "spadl"], check=True,
                                  stdout=subprocess.PIPE, text=True).stdout
        actions = pandas.read_csv(io.StringIO(text))
        self.assertGreater(len(actions), 20)
        checked = spadl.SPADLSchema.validate(actions)
        named = spadl.add_names(checked)
        self.assertFalse(named[["type_name", "result_name", "bodypart_name"]].isna().any().any())

        for _, game in named.groupby("game_id"):
            game = game.reset_index(drop=True)
            states = features.gamestates(game, 3)
            home = game.team_id.iloc[0]
            states = features.play_left_to_right(states, home)
            for compute in (features.actiontype_onehot, features.result_onehot,
                            features.startlocation, features.endlocation, features.movement,
                            features.space_delta, features.time, features.time_delta,
                            features.team, features.goalscore):
                rows = compute(states)
                self.assertEqual(len(rows), len(game), compute.__name__)
                self.assertFalse(rows.isna().any().any(), compute.__name__)
            self.assertEqual(len(labels.scores(game)), len(game))
            self.assertEqual(len(labels.concedes(game)), len(game))


if __name__ == "__main__":
    unittest.main()
