"""The same replies as the teams in other languages: fixtures/team, written by examples/vectors.py."""
import os
import unittest

from cls_playmaker import proto as pb, team_playmaker_pb2 as wire

import decide

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../fixtures/team")
DECISIONS = {12: (decide.decide_as_coach, pb.CoachActions),
             13: (decide.decide_as_trainer, pb.TrainerActions)}


def read(name, message):
    with open(os.path.join(FOLDER, name), "rb") as file:
        return message.FromString(file.read())


class Vectors(unittest.TestCase):
    def test_replies_to_recorded_states(self):
        request = read("states.bin", wire.GetTeamActionsRequest)
        expected = read("replies.bin", wire.GetTeamActionsResponse)
        self.assertGreater(len(request.agents), 50)
        for index, (agent, reply) in enumerate(zip(request.agents, expected.agents)):
            method, kind = DECISIONS.get(agent.agent, (decide.decide, pb.PlayerActions))
            with self.subTest(state=index):
                self.assertEqual(method(pb.State.FromString(agent.message)),
                                 kind.FromString(reply.message))


if __name__ == "__main__":
    unittest.main()
